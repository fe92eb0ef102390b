#include "tool.hpp"

#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "commands/command.hpp"
#include "mesh/bad_input.hpp"

namespace osem::host {

namespace {

constexpr const char* description =
    "Osem: boundary-represented solids to octrees and Booleans of octrees, on integers alone.";
constexpr const char* exit_codes =
    "Exit codes: 0 done; 1 wrong usage; 2 a file cannot be read, used or written.\n"
    "On failure one line says why, and no output file is left or replaced; a stack keeps pictures that were "
    "done.";

// A file name or a library's message may hold line breaks; the report stays one line whatever it quotes.
void report(std::ostream& err, const std::string& message) {
    std::string line = "osem: " + message;
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    line.erase(line.find_last_not_of(' ') + 1);
    err << line << std::endl;
}

bool is_terminal(const std::ostream& err) { return &err == &std::cerr && isatty(STDERR_FILENO) != 0; }

void add_commands(CLI::App& app, const Console& console) {
    add_check(app, console);
    add_convert(app, console);
    add_combinations(app, console);
    add_complement(app, console);
    add_csg(app, console);
    add_coarsen(app, console);
    add_info(app, console);
    add_measure(app, console);
    add_query(app, console);
    add_collide(app, console);
    add_leaves(app, console);
    add_image(app, console);
    add_slice(app, console);
    add_mesh(app, console);
    add_transform(app, console);
    add_carray(app, console);
}

// The last lines of every command's help, also of the commands of a command.
void add_exit_codes(CLI::App& app) { // NOLINT(misc-no-recursion): as deep as commands have commands
    const std::string footer = app.get_footer();
    app.footer(footer.empty() ? exit_codes : footer + '\n' + exit_codes);
    for (CLI::App* command : app.get_subcommands({})) add_exit_codes(*command);
}

// What was wrong with the line. Of a word that is no command the parser only says that one is missing.
std::string fault_text(const CLI::App& app, const CLI::ParseError& fault) {
    const CLI::App* command = &app;
    std::string name = app.get_name();
    while (!command->get_subcommands().empty()) {
        command = command->get_subcommands().back();
        name += ' ' + command->get_name();
    }
    if (command->get_require_subcommand_min() == 0 || fault.get_name() != "RequiredError") {
        return fault.what();
    }
    const std::vector<std::string> unknown = command->remaining();
    const std::string hint = "; " + name + " --help lists them";
    return (unknown.empty() ? name + " wants a command" : unknown[0] + " is no command of " + name) + hint;
}

int parse_and_run(int argc, const char* const* argv, const Console& console) {
    CLI::App app(description, "osem");
    app.require_subcommand(1);
    app.set_version_flag("--version", OSEM_VERSION);
    app.get_formatter()->column_width(34);
    add_commands(app, console);
    add_exit_codes(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
            app.exit(e, console.out, console.err); // --help, --version
        } else {
            report(console.err, fault_text(app, e));
            return exit_bad_usage;
        }
    }
    finish_printing(console);
    return exit_ok;
}

} // namespace

int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
    const Console console{out, err, is_terminal(err)};
    try {
        return parse_and_run(argc, argv, console);
    } catch (const std::bad_alloc&) {
        report(err, "not enough memory");
    } catch (const std::exception& e) {
        report(err, e.what());
    }
    return exit_bad_input;
}

} // namespace osem::host
