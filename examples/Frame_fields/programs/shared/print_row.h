#ifndef FRAME_FIELDS_PROGRAMS_PRINT_ROW_H
#define FRAME_FIELDS_PROGRAMS_PRINT_ROW_H

#include <iomanip>
#include <iostream>
#include <string>

template <typename Value>
void print_row(const std::string& name, const Value& value)
{
  std::cout << std::left << std::setw(23) << name << value << "\n";
}

#endif // FRAME_FIELDS_PROGRAMS_PRINT_ROW_H
