//! Exact solutions, metrics, tables and charts. Takes plain arrays and shares no code with the
//! solver, which keeps the check independent.
