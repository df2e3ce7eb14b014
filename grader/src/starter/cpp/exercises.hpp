// How each exercise is asked: its question is read, its function called, its answer written.

#pragma once

#include <functional>
#include <map>
#include <ostream>
#include <string>

struct Words;

using Exercise = std::function<void(Words&, std::ostream&)>;

extern const std::map<std::string, Exercise> EXERCISES;
