//! Type of a function call.

use super::form::{Conflict, Form};
use super::infer::Inference;
use super::terms::{Place, Term};
use super::types::Type;
use crate::tables::TableFunction;
use crate::{Expression, Name};
use program::functions::{Function, Rule};
use units::{Exponent, Words, words};

impl Inference<'_> {
    /// Type of a call of a built-in function or of a table.
    pub(super) fn call(&mut self, name: &Name, arguments: &[Expression]) -> Type {
        if let (Some(table), [argument]) = (self.scope.table(&name.text), arguments) {
            return self.look_up(name, table, argument);
        }
        let Some(function) = Function::named(&name.text).filter(|function| function.takes(arguments.len())) else {
            for argument in arguments {
                self.expression(argument);
            }
            return Type::Unknown;
        };
        let user = || Words::same(format!("`{}`", function.name));
        if let [first, ..] = arguments
            && function.dimensions == Rule::Same
            && self.are_alike(arguments)
        {
            return self.number(first, &user).map_or(Type::Unknown, Type::Number);
        }
        let forms: Vec<Option<Form>> = arguments.iter().map(|argument| self.number(argument, &user)).collect();
        match function.dimensions {
            Rule::Pure | Rule::Whole => {
                for (argument, form) in arguments.iter().zip(forms) {
                    if let Some(form) = form {
                        self.pure(argument, &form, || words!("the argument of {user}", user = user()));
                    }
                }
                Type::Number(Form::pure())
            }
            Rule::Root(degree) => {
                let Some(form) = forms.into_iter().flatten().next() else { return Type::Unknown };
                let root = Exponent::new(1, i64::from(degree)).and_then(|exponent| form.power(exponent).ok());
                root.map_or_else(|| self.too_large(name.span), Type::Number)
            }
            Rule::Rest => {
                let rest = arguments.iter().zip(forms).skip(1);
                let terms: Vec<Term> = rest.map(|(expression, form)| Term { expression, form }).collect();
                self.equal(&terms, Place::Arguments)
            }
            Rule::Same | Rule::Ratio => {
                let terms: Vec<Term> =
                    arguments.iter().zip(forms).map(|(expression, form)| Term { expression, form }).collect();
                let common = self.equal(&terms, Place::Arguments);
                if function.dimensions == Rule::Same { common } else { Type::Number(Form::pure()) }
            }
        }
    }

    /// Type of a table's value. Checks the dimension of the argument.
    fn look_up(&mut self, name: &Name, table: &TableFunction, argument: &Expression) -> Type {
        let user = || words!("the argument of `{}`", name.text);
        if let Some(form) = self.number(argument, &user) {
            let needed = Form::from(table.argument);
            match self.solver.unify(&form, &needed, argument.span) {
                Ok(()) => {}
                Err(Conflict::TooLarge) => return self.too_large(argument.span),
                Err(Conflict::Different) => {
                    let title = format!("`{}`", table.argument_name);
                    let context = words!(", as the argument of `{}`", name.text);
                    self.report_value((argument, &form), (&title, &needed, table.span), &context);
                }
            }
        }
        Type::Number(table.value.into())
    }
}
