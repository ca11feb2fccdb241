//! Packings of bodies: one program, for each takes as long to build as all together.

mod bodies;
mod defects;
mod fins;
mod layers;
mod mirrors;
mod mutations;
mod quality;
mod shapes;
mod thin_parts;
mod too_thin;
mod triangulations;
