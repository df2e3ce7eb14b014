// The answer program: a question per line in, an answer per line out. raybook wrote it; you need not change it.
//
// `raybook check` asks it, and so can you:   echo 'ray_at 0 0 0  1 0 0  2.5' | build/answer

#include "exercises.hpp"
#include "words.hpp"

#include <cstdio>
#include <exception>
#include <iomanip>
#include <iostream>
#include <limits>

// The answer to a line, after the `=`.
static std::string answer(const std::string& line) {
    Words words{std::istringstream(line)};
    std::ostringstream out;
    out << std::setprecision(std::numeric_limits<double>::max_digits10);
    try {
        const std::string name = words.word();
        const auto exercise = EXERCISES.find(name);
        if (exercise == EXERCISES.end()) {
            return " error there is no exercise `" + name + "`";
        }
        exercise->second(words, out);
        return out.str();
    } catch (const Todo& todo) {
        return " todo " + todo.name;
    } catch (const NoQuestion& no) {
        return " error " + no.why;
    } catch (const std::exception& error) {
        return std::string(" panic ") + error.what();
    } catch (...) {
        return " panic something was thrown that is no std::exception";
    }
}

// Where a program of `make debug` is stopped by the standard library, it tells the line, too.
extern "C" const char* __asan_default_options() { return "handle_abort=1"; }

int main() {
    std::ios::sync_with_stdio(false);  // long questions are read in a third of the time
    for (std::string line; std::getline(std::cin, line);) {
        const std::string said = answer(line);
        std::fflush(stdout);
        // What the function printed may have left the line open, and an answer begins one.
        std::cout << "\n=" << said << std::endl;
    }
}
