//! The small reference tables that lie beside each case's README, compiled into the crate so that
//! `aero validate` works from any directory.
//!
//! A table is numbers under column names; a column called `name` holds labels instead.

/// Columns of numbers, with a label per row where the file has a `name` column.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    names: Vec<String>,
    columns: Vec<Vec<f64>>,
    labels: Vec<String>,
    rows: usize,
}

/// What is wrong with a table.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TableError {
    /// A line has more or fewer cells than the header.
    #[error("line {line} has {found} cells, the header {expected}; give every row all columns")]
    Ragged {
        /// Line in the file, from 1.
        line: usize,
        /// Cells on it.
        found: usize,
        /// Cells in the header.
        expected: usize,
    },
    /// A cell is not a number.
    #[error("line {line}, column `{column}`: `{cell}` is not a number")]
    NotANumber {
        /// Line in the file, from 1.
        line: usize,
        /// Name of the column.
        column: String,
        /// The cell.
        cell: String,
    },
    /// No column of that name.
    #[error("no column `{0}` in the table")]
    NoColumn(String),
}

impl Table {
    /// Reads comma-separated values with a header; blank lines and lines starting with `#` are
    /// skipped.
    pub fn parse(text: &str) -> Result<Self, TableError> {
        let mut lines = text
            .lines()
            .enumerate()
            .map(|(k, line)| (k + 1, line.trim()))
            .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
        let header: Vec<&str> = lines.next().map_or(Vec::new(), |(_, line)| split(line));
        let mut table = Self {
            names: header
                .iter()
                .filter(|n| **n != "name")
                .map(ToString::to_string)
                .collect(),
            columns: Vec::new(),
            labels: Vec::new(),
            rows: 0,
        };
        table.columns = vec![Vec::new(); table.names.len()];
        for (line, text) in lines {
            let cells = split(text);
            if cells.len() != header.len() {
                return Err(TableError::Ragged {
                    line,
                    found: cells.len(),
                    expected: header.len(),
                });
            }
            let mut column = 0;
            for (name, cell) in header.iter().zip(cells) {
                if *name == "name" {
                    table.labels.push(cell.to_owned());
                    continue;
                }
                let value = cell.parse().map_err(|_| TableError::NotANumber {
                    line,
                    column: (*name).to_owned(),
                    cell: cell.to_owned(),
                })?;
                table.columns[column].push(value);
                column += 1;
            }
            table.rows += 1;
        }
        Ok(table)
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows
    }

    /// True for a table of no rows.
    pub fn is_empty(&self) -> bool {
        self.rows == 0
    }

    /// Names of the numeric columns, in the file's order.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Labels of the rows, none if the file has no `name` column.
    pub fn labels(&self) -> &[String] {
        &self.labels
    }

    /// The column called `name`.
    pub fn column(&self, name: &str) -> Result<&[f64], TableError> {
        self.names
            .iter()
            .position(|n| n == name)
            .map(|k| self.columns[k].as_slice())
            .ok_or_else(|| TableError::NoColumn(name.to_owned()))
    }

    /// Value of column `y` where column `x`, which must not fall, is `at`; linear between rows, the
    /// end rows' values outside. None for an unknown column or an empty table.
    pub fn interpolate(&self, x: &str, y: &str, at: f64) -> Option<f64> {
        let (x, y) = (self.column(x).ok()?, self.column(y).ok()?);
        let above = x.partition_point(|v| *v <= at);
        if above == 0 {
            return y.first().copied();
        }
        if above == x.len() {
            return y.last().copied();
        }
        let share = (at - x[above - 1]) / (x[above] - x[above - 1]);
        Some(y[above - 1] + share * (y[above] - y[above - 1]))
    }
}

fn split(line: &str) -> Vec<&str> {
    line.split(',').map(str::trim).collect()
}

macro_rules! tables {
    ($($(#[$doc:meta])* $name:ident = $path:literal;)*) => {
        $(
            $(#[$doc])*
            ///
            /// # Panics
            /// Never: a test reads every table of the crate.
            pub fn $name() -> Table {
                Table::parse(include_str!(concat!("../", $path))).expect(concat!($path, " is a table"))
            }
        )*

        #[cfg(test)]
        const ALL: &[(&str, fn() -> Table)] = &[$(($path, $name)),*];
    };
}

tables! {
    /// Oblique shocks of the wedge cases.
    wedge = "wedge/oblique_shock.csv";
    /// Finite-volume codes on the Mach 2.5, 20 degree wedge: error against CPU seconds.
    wedge_peers = "wedge/peers.csv";
    /// Particle updates per CPU second that `PySPH` reaches on the wedge, against the number of particles.
    wedge_pysph = "wedge/pysph.csv";
    /// Detachment angles and stagnation values against Mach number.
    detachment = "wedge/detachment.csv";
    /// Reflecting Sod tube: exact profiles at four times.
    sod_profiles = "sod/profiles.csv";
    /// Reflecting Sod tube: exact states and times, by name.
    sod_states = "sod/states.csv";
    /// Billig's stand-off and vertex radius against Mach number, cylinders and spheres.
    billig = "sphere/billig.csv";
    /// Billig's shock shape ahead of the Mach 10 cylinder.
    billig_cylinder_shape = "cylinder/billig_shape.csv";
    /// Finite-volume shock position ahead of the Mach 10 cylinder.
    cylinder_shock = "cylinder/shock.csv";
    /// Finite-volume wall pressure on the Mach 10 cylinder.
    cylinder_wall = "cylinder/wall.csv";
    /// Finite-volume position of the bow shock ahead of the Mach 3 forward-facing step.
    step_shock = "step/shock.csv";
    /// Finite-volume Mach number on the planar nozzle's centre line and wall.
    nozzle_centre_line = "nozzle/centre_line.csv";
    /// Quasi-one-dimensional planar nozzle.
    nozzle_planar = "nozzle/quasi_1d_planar.csv";
    /// Quasi-one-dimensional round nozzle.
    nozzle_axisymmetric = "nozzle/quasi_1d_axisymmetric.csv";
    /// Internal normal shocks of the planar nozzle.
    nozzle_internal_shock = "nozzle/internal_shock.csv";
    /// Shock-expansion theory on the biconvex aerofoil.
    biconvex = "biconvex/surface.csv";
    /// Forces on the rotating square, digitised from the Eilmer example set.
    rotating_square = "rotating_square/forces.csv";
    /// Taylor-Maccoll cones.
    cones = "cone/taylor_maccoll.csv";
    /// Prandtl-Meyer fans at convex corners.
    expansion_corner = "expansion_corner/fans.csv";
    /// Pistons at constant speed.
    piston = "piston/constant_speed.csv";
    /// Accelerating pistons.
    accelerating_piston = "piston/accelerating.csv";
    /// Noh's implosion.
    noh = "noh/plateau.csv";
    /// Sedov's constants.
    sedov = "sedov/constants.csv";
    /// Riemann problems: Toro's five and others.
    riemann_suite = "riemann/suite.csv";
    /// Woodward and Colella's interacting blast waves, finite volumes.
    blast = "blast/profile.csv";
    /// Shu and Osher's shock and entropy wave, finite volumes.
    shu_osher = "shu_osher/profile.csv";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_of_the_crate_reads_and_has_rows() {
        for (path, read) in ALL {
            let table = read();
            assert!(!table.is_empty(), "{path}");
            assert!(
                table.labels().is_empty() || table.labels().len() == table.len(),
                "{path}"
            );
        }
    }

    #[test]
    fn a_ragged_line_and_a_word_among_numbers_are_named() {
        let error = Table::parse("a,b\n1,2\n3\n").unwrap_err();
        assert_eq!(
            error,
            TableError::Ragged {
                line: 3,
                found: 1,
                expected: 2
            }
        );
        let error = Table::parse("a,b\n1,two\n").unwrap_err();
        assert_eq!(
            error.to_string(),
            "line 2, column `b`: `two` is not a number"
        );
    }

    #[test]
    fn labels_stand_apart_from_numbers() {
        let table = Table::parse("name,v\n# a remark\nfirst,1\n\nsecond,2\n").unwrap();
        assert_eq!(table.labels(), ["first", "second"]);
        assert_eq!(table.column("v").unwrap(), [1.0, 2.0]);
        assert!(table.column("name").is_err());
    }

    #[test]
    fn interpolation_is_linear_inside_and_constant_outside() {
        let table = Table::parse("x,y\n0,0\n1,10\n3,20\n").unwrap();
        assert_eq!(table.interpolate("x", "y", 0.5), Some(5.0));
        assert_eq!(table.interpolate("x", "y", 2.0), Some(15.0));
        assert_eq!(table.interpolate("x", "y", -1.0), Some(0.0));
        assert_eq!(table.interpolate("x", "y", 9.0), Some(20.0));
        assert_eq!(table.interpolate("x", "z", 1.0), None);
    }
}
