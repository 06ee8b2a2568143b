#include <reeve/core/version.hpp>

#include <iostream>

int main() { std::cout << reeve::version().number << '\n'; }
