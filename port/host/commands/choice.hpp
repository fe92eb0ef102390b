// Options that take one word of a few.
#ifndef OSEM_HOST_CHOICE_HPP
#define OSEM_HOST_CHOICE_HPP

#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

namespace osem::host {

template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// Adds an option that sets `target` (a Value or an optional one) to the value of the word given; any other
/// word is wrong usage.
template <class Value, class Target>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Target& target, const std::string& help,
                        const Choices<Value>& choices) {
    const auto set = [&target, choices](const std::string& word) {
        for (const auto& [known, value] : choices) {
            if (word == known) target = value;
        }
    };
    const auto fault = [choices](const std::string& word) {
        std::string expected = "expected one of";
        for (const auto& choice : choices) {
            if (word == choice.first) return std::string();
            expected += ' ' + choice.first;
        }
        return expected;
    };
    return command.add_option_function<std::string>(name, set, help)->check(fault);
}

} // namespace osem::host

#endif
