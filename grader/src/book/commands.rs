//! `{{commands raybook}}`: the commands with their parameters, as `raybook --help` tells them.

use clap::{Arg, Command};
use maud::{Markup, html};

/// The page that lists the commands.
pub(super) const PAGE: &str = "commands.md";

/// The commands that help tells of.
pub(super) fn shown(command: &Command) -> impl Iterator<Item = &Command> {
    command
        .get_subcommands()
        .filter(|command| !command.is_hide_set())
}

/// A table of parameters for each command.
///
/// # Errors
/// If this is not the name of the command.
pub(super) fn expand(name: &str, command: &Command) -> Result<String, String> {
    if name != command.get_name() {
        return Err(format!(
            "the command is {}, not `{name}`",
            command.get_name()
        ));
    }
    let mut command = command.clone();
    command.build();
    let text = html! {
        @for command in shown(&command) {
            h2 id=(command.get_name()) { code { (name) " " (command.get_name()) } }
            p { (command.get_about().map(ToString::to_string).unwrap_or_default()) "." }
            (parameters(command))
            @for below in shown(command).filter(|below| below.get_name() != "help") {
                p { code { (name) " " (command.get_name()) " " (below.get_name()) } ": " (below.get_about().map(ToString::to_string).unwrap_or_default()) "." }
                (parameters(below))
            }
        }
    };
    Ok(text.into_string())
}

/// A row for each parameter of a command.
fn parameters(command: &Command) -> Markup {
    let arguments = || {
        command
            .get_arguments()
            .filter(|argument| !argument.is_hide_set() && argument.get_id() != "help")
    };
    html! {
        @if arguments().next().is_some() {
            table class="parameters" { tbody {
                @for argument in arguments() { tr { td { code { (argument.to_string()) } } td { (meaning(argument)) } } }
            } }
        }
    }
}

/// What a parameter means, and its value where nobody gives one.
fn meaning(argument: &Arg) -> Markup {
    let help = argument.get_help().map(ToString::to_string);
    let help = help.unwrap_or_default();
    let values = argument.get_default_values().iter();
    let values: Vec<_> = values.map(|value| value.to_string_lossy()).collect();
    let default = values.join(" ");
    let is_told = argument.get_action().takes_values() && !argument.is_hide_default_value_set();
    html! {
        @for (i, part) in help.split('`').enumerate() {
            @if i % 2 == 0 { (part) } @else { code { (part) } }
        }
        @if is_told && !default.is_empty() { " (default: " code { (default) } ")" }
    }
}
