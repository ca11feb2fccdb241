//! What Negi & Ramachandran 2022 print of packed concave walls (table I): mean errors at 1/500 and orders.

use super::solution::Condition;

/// Error and order where they can be read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Printed {
    pub error: f64,
    pub order: Option<f64>,
}

/// The figures of a treatment. The manuscript's text keeps the first three numbers of each line: orders of slip and no-slip are lost, and the
/// errors of Adami, Colagrossi and Marrone beside Neumann's stand where those of slip walls do.
pub fn printed(treatment: &str, condition: Condition) -> Option<Printed> {
    let (error, order) = match (treatment, condition) {
        ("Adami 2012", Condition::Neumann) => (1.17e-5, Some(2.00)),
        ("Colagrossi 2003", Condition::Neumann) => (1.18e-5, Some(2.00)),
        ("Hashemi 2012", Condition::Neumann) => (4.39e-3, Some(0.47)),
        ("Marongiu 2007", Condition::Neumann) => (1.14e-3, Some(0.63)),
        ("Marrone 2011", Condition::Neumann) => (1.15e-5, Some(2.00)),
        ("Adami 2012", Condition::Slip) => (5.26e-5, None),
        ("Colagrossi 2003", Condition::Slip) => (7.47e-5, None),
        ("Marrone 2011", Condition::Slip) => (1.00e-6, None),
        ("Esmaili 2016", Condition::NoSlip) => (2.54e-3, None),
        ("Hashemi 2012", Condition::NoSlip) => (2.11e-3, None),
        ("Randles 1996", Condition::NoSlip) => (2.91e-3, None),
        ("Takeda 1994", Condition::NoSlip) => (8.63e-4, None),
        _ => return None,
    };
    Some(Printed { error, order })
}
