//! From the text of a formula to its tree.

use super::{Function, Node, Operator, Variable};

/// Operators and signs in one formula; the stack would hold many more.
const LONGEST: usize = 1000;

/// Functions by name, with the number of their arguments.
const FUNCTIONS: [(&str, Function, usize); 10] = [
    ("sin", Function::Sin, 1),
    ("cos", Function::Cos, 1),
    ("exp", Function::Exp, 1),
    ("ln", Function::Ln, 1),
    ("sqrt", Function::Sqrt, 1),
    ("abs", Function::Abs, 1),
    ("tanh", Function::Tanh, 1),
    ("min", Function::Min, 2),
    ("max", Function::Max, 2),
    ("if", Function::If, 3),
];

/// Parses a whole formula, which `knows_time` or does not.
///
/// # Errors
/// Says what is wrong and shows where.
pub(super) fn parse(text: &str, knows_time: bool) -> Result<Node, String> {
    let mut parser = Parser {
        text,
        at: 0,
        depth: 0,
        knows_time,
    };
    let node = parser.comparison()?;
    match parser.peek() {
        None => Ok(node),
        Some(')') => Err(parser.fail("a `)` closes nothing")),
        Some(_) => Err(parser.fail("an operator is missing")),
    }
}

struct Parser<'a> {
    text: &'a str,
    /// Byte that comes next.
    at: usize,
    depth: usize,
    knows_time: bool,
}

impl Parser<'_> {
    fn comparison(&mut self) -> Result<Node, String> {
        let left = self.sum()?;
        for (sign, operator) in [
            ("<=", Operator::AtMost),
            (">=", Operator::AtLeast),
            ("<", Operator::Less),
            (">", Operator::Greater),
        ] {
            if self.take(sign) {
                let right = self.sum()?;
                return Ok(pair(operator, left, right));
            }
        }
        Ok(left)
    }

    fn sum(&mut self) -> Result<Node, String> {
        let mut node = self.product()?;
        loop {
            let operator = if self.take("+") {
                Operator::Add
            } else if self.take("-") {
                Operator::Subtract
            } else {
                return Ok(node);
            };
            self.deeper()?;
            node = pair(operator, node, self.product()?);
        }
    }

    fn product(&mut self) -> Result<Node, String> {
        let mut node = self.signed()?;
        loop {
            let operator = if self.take("*") {
                Operator::Multiply
            } else if self.take("/") {
                Operator::Divide
            } else {
                return Ok(node);
            };
            self.deeper()?;
            node = pair(operator, node, self.signed()?);
        }
    }

    fn signed(&mut self) -> Result<Node, String> {
        self.deeper()?;
        if self.take("-") {
            return Ok(Node::Negative(Box::new(self.signed()?)));
        }
        let base = self.atom()?;
        if self.take("^") {
            let exponent = self.signed()?;
            return Ok(pair(Operator::Power, base, exponent));
        }
        Ok(base)
    }

    fn atom(&mut self) -> Result<Node, String> {
        if self.take("(") {
            let node = self.comparison()?;
            return self.close().map(|()| node);
        }
        match self.peek() {
            None => Err(self.fail("it ends too early")),
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() => self.name(),
            Some(_) => Err(self.fail("a number, a name or `(` is missing")),
        }
    }

    fn number(&mut self) -> Result<Node, String> {
        let rest = &self.text[self.at..];
        let mut previous = ' ';
        let end = rest.find(|c: char| {
            let sign = matches!(c, '+' | '-') && matches!(previous, 'e' | 'E');
            previous = c;
            !(sign || c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E'))
        });
        let digits = &rest[..end.unwrap_or(rest.len())];
        match digits.parse::<f64>() {
            Ok(number) if number.is_finite() => {
                self.at += digits.len();
                Ok(Node::Number(number))
            }
            _ => Err(self.fail(&format!("`{digits}` is not a number"))),
        }
    }

    fn name(&mut self) -> Result<Node, String> {
        let rest = &self.text[self.at..];
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
        let name = &rest[..end.unwrap_or(rest.len())];
        let variable = match name {
            "x" => Some(Variable::Axis(0)),
            "y" => Some(Variable::Axis(1)),
            "z" => Some(Variable::Axis(2)),
            "r" => Some(Variable::Radius),
            "dx" => Some(Variable::Spacing),
            "t" if self.knows_time => Some(Variable::Time),
            _ => None,
        };
        if let Some(variable) = variable {
            self.at += name.len();
            return Ok(Node::Variable(variable));
        }
        if name == "pi" {
            self.at += name.len();
            return Ok(Node::Number(std::f64::consts::PI));
        }
        let Some(&(_, function, count)) = FUNCTIONS.iter().find(|entry| entry.0 == name) else {
            let known = FUNCTIONS.map(|entry| entry.0).join(", ");
            let time = if self.knows_time { "t, " } else { "" };
            return Err(self.fail(&format!(
                "`{name}` is unknown; there are x, y, z, r, {time}dx, pi and the functions {known}"
            )));
        };
        self.at += name.len();
        if !self.take("(") {
            return Err(self.fail(&format!("`{name}` is a function and needs a `(`")));
        }
        let mut arguments = vec![self.comparison()?];
        while self.take(",") {
            arguments.push(self.comparison()?);
        }
        if arguments.len() != count {
            let given = arguments.len();
            return Err(self.fail(&format!("`{name}` takes {count} arguments, not {given}")));
        }
        self.close().map(|()| Node::Call(function, arguments))
    }

    fn close(&mut self) -> Result<(), String> {
        if self.take(")") {
            Ok(())
        } else {
            Err(self.fail("a `)` is missing"))
        }
    }

    /// Guards the stack: every level of the tree passes here.
    fn deeper(&mut self) -> Result<(), String> {
        self.depth += 1;
        if self.depth > LONGEST {
            return Err(self.fail("it is too long"));
        }
        Ok(())
    }

    fn peek(&self) -> Option<char> {
        self.text[self.at..].trim_start().chars().next()
    }

    /// Takes `sign` if it comes next; blanks before it, or before what else comes, are skipped.
    fn take(&mut self, sign: &str) -> bool {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        let found = self.text[self.at..].starts_with(sign);
        if found {
            self.at += sign.len();
        }
        found
    }

    fn fail(&self, what: &str) -> String {
        let mut rest: String = self.text[self.at..].chars().take(20).collect();
        if rest.is_empty() {
            rest = "its end".into();
        } else {
            rest = format!("`{rest}`");
        }
        format!("the formula makes no sense at {rest}: {what}")
    }
}

fn pair(operator: Operator, left: Node, right: Node) -> Node {
    Node::Pair(operator, Box::new([left, right]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_makes_no_sense_is_shown() {
        for (text, words) in [
            ("", "ends too early"),
            ("1 +", "ends too early"),
            ("2 x", "at `x`: an operator is missing"),
            ("(1", "a `)` is missing"),
            ("1)", "closes nothing"),
            ("q * 2", "`q` is unknown"),
            ("sin x", "needs a `(`"),
            ("max(1)", "takes 2 arguments, not 1"),
            ("1.2.3", "`1.2.3` is not a number"),
            ("1e999", "not a number"),
            ("$", "a number, a name or `(`"),
            ("ä + 1", "`ä` is unknown"),
        ] {
            let message = parse(text, false).unwrap_err();
            assert!(message.contains(words), "{text}: {message}");
        }
    }

    #[test]
    fn no_depth_exhausts_the_stack() {
        for text in [
            "(".repeat(100_000),
            "-".repeat(100_000),
            "1+".repeat(100_000),
        ] {
            // As much as the program has: tests get a quarter of it, and code that is not optimised asks for more.
            let thread = std::thread::Builder::new().stack_size(8 << 20);
            let parsed = thread.spawn(move || parse(&text, false).unwrap_err());
            assert!(parsed.unwrap().join().unwrap().contains("too long"));
        }
    }
}
