#ifndef FRAME_FIELDS_PROGRAMS_APPENDED_ARRAYS_H
#define FRAME_FIELDS_PROGRAMS_APPENDED_ARRAYS_H

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

// The arrays of a VTK XML file: elements in its text refer to raw binary data at its end.
class Appended_arrays
{
public:
  // Keeps the values for the end of the file, and returns the XML element that refers to them.
  template <typename T>
  std::string add(const std::string& name, const std::vector<T>& values, const int number_of_components = 1)
  {
    std::ostringstream element;
    element << "<DataArray type=\"" << type_name(T()) << "\" Name=\"" << name << "\" NumberOfComponents=\""
            << number_of_components << "\" format=\"appended\" offset=\"" << m_data.size() << "\"/>\n";
    const std::uint64_t number_of_bytes = values.size() * sizeof(T);
    append(&number_of_bytes, sizeof(number_of_bytes));
    append(values.data(), number_of_bytes);
    return element.str();
  }

  const std::string& data() const { return m_data; }

private:
  static const char* type_name(double) { return "Float64"; }
  static const char* type_name(std::int32_t) { return "Int32"; }
  static const char* type_name(std::int64_t) { return "Int64"; }

  void append(const void* const bytes, const std::size_t number_of_bytes)
  {
    m_data.append(static_cast<const char*>(bytes), number_of_bytes);
  }

  std::string m_data;
};

#endif // FRAME_FIELDS_PROGRAMS_APPENDED_ARRAYS_H
