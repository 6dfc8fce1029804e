// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend-polydata: VTK's polydata into PLY, and back. Reads from its standard input, writes to its standard output; what fails is a
// sentence on its standard error, with exit code 3. Arrays of VTK have any number of values per row, properties of PLY one:
// io/polydata.h says how they are called.
#include "core/error.h"
#include "io/ply_values.h"
#include "io/polygon_soup.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace loopmend {
namespace {

/// Keeps the first error of VTK, which goes to the terminal else.
class FirstError : public vtkOutputWindow {
 public:
  static FirstError* New();
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* given) override {
    if (!text_.empty()) return;
    // "ERROR: In FILE, line N\nCLASS (ADDRESS): SENTENCE\n\n"
    text_ = given;
    if (const std::size_t at = text_.find("): "); at != std::string::npos) text_.erase(0, at + 3);
    text_.erase(std::min(text_.find('\n'), text_.size()));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};
vtkStandardNewMacro(FirstError)

    constexpr std::array color_names{"red", "green", "blue", "alpha"};
constexpr std::array normal_names{"nx", "ny", "nz"};
constexpr std::array texture_names{"s", "t"};

ScalarType scalar_type(vtkDataArray& array) {
  switch (array.GetDataType()) {
    case VTK_CHAR:
    case VTK_SIGNED_CHAR: return ScalarType::int8;
    case VTK_BIT:
    case VTK_UNSIGNED_CHAR: return ScalarType::uint8;
    case VTK_SHORT: return ScalarType::int16;
    case VTK_UNSIGNED_SHORT: return ScalarType::uint16;
    case VTK_INT: return ScalarType::int32;
    case VTK_UNSIGNED_INT: return ScalarType::uint32;
    case VTK_FLOAT: return ScalarType::float32;
    case VTK_DOUBLE: return ScalarType::float64;
    default: break;
  }
  // PLY has no whole numbers of 64 bits.
  for (int k = 0; k < array.GetNumberOfComponents(); ++k) {
    std::array<double, 2> range{};
    array.GetRange(range.data(), k);
    if (range[0] < std::numeric_limits<int>::min() || range[1] > std::numeric_limits<int>::max())
      return ScalarType::float64;
  }
  return ScalarType::int32;
}

int vtk_type(ScalarType type) {
  switch (type) {
    case ScalarType::int8: return VTK_SIGNED_CHAR;
    case ScalarType::uint8: return VTK_UNSIGNED_CHAR;
    case ScalarType::int16: return VTK_SHORT;
    case ScalarType::uint16: return VTK_UNSIGNED_SHORT;
    case ScalarType::int32: return VTK_INT;
    case ScalarType::uint32: return VTK_UNSIGNED_INT;
    case ScalarType::float32: return VTK_FLOAT;
    case ScalarType::float64: break;
  }
  return VTK_DOUBLE;
}

// ---- from VTK to PLY ----

vtkSmartPointer<vtkPolyData> parsed(const std::string& bytes) {
  if (!bytes.starts_with("# vtk")) {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->ReadFromInputStringOn();
    reader->SetInputString(bytes);
    reader->Update();
    return reader->GetOutput();
  }
  if (bytes.size() > std::numeric_limits<int>::max()) throw std::runtime_error("it reads .vtk files of up to 2 GB");
  vtkNew<vtkPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetBinaryInputString(bytes.data(), static_cast<int>(bytes.size()));
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  reader->Update();
  return reader->GetOutput();
}

/// A word of a PLY header has no spaces; '%' and two digits stand for one, as in an address.
std::string property_name(const char* array) {
  std::string name;
  for (const char* c = array ? array : ""; *c; ++c) {
    constexpr const char* digits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(*c);
    if (byte > ' ' && byte != '%' && byte != 127)
      name += *c;
    else
      (name += '%') += {digits[byte / 16], digits[byte % 16]};
  }
  return name.empty() ? "array" : name;
}

/// Colours are the first array of three or four bytes per row.
std::vector<std::string> names_of_columns(vtkDataSetAttributes& data, vtkDataArray& array, bool has_colors) {
  const int count = array.GetNumberOfComponents();
  if (&array == data.GetNormals() && count == 3) return {normal_names.begin(), normal_names.end()};
  if (&array == data.GetTCoords() && count == 2) return {texture_names.begin(), texture_names.end()};
  const bool bytes = array.GetDataType() == VTK_UNSIGNED_CHAR && (count == 3 || count == 4);
  if (bytes && !has_colors) return {color_names.begin(), color_names.begin() + count};
  const std::string name = property_name(array.GetName());
  if (count == 1) return {name};
  std::vector<std::string> names;
  for (int k = 0; k < count; ++k) names.push_back(name + "_" + std::to_string(k));
  return names;
}

class PlyText {
 public:
  void remark_lost(vtkIdType count, const std::string& what) {
    if (count > 0) header_ << "comment loopmend-polydata " << count << ' ' << what << '\n';
  }
  void element(const char* name, std::size_t rows) { elements_ << "element " << name << ' ' << rows << '\n'; }
  void list() { elements_ << "property list int int vertex_indices\n"; }
  void property(ScalarType type, const std::string& name) {
    elements_ << "property " << ply_name(type) << ' ' << name << '\n';
  }
  void value(ScalarType type, double value) { values_.put(type, value); }
  void index(vtkIdType value) {
    constexpr vtkIdType most = std::numeric_limits<std::int32_t>::max();
    values_.put(ScalarType::int32, static_cast<double>(std::clamp<vtkIdType>(value, -1, most)));
  }
  void print() {
    out_.finish();
    std::cout << "ply\nformat binary_little_endian 1.0\n"
              << header_.str() << elements_.str() << "end_header\n"
              << body_.view();
  }

 private:
  std::ostringstream header_, elements_, body_;
  Output out_{body_, nullptr};
  PlyValues values_{out_, Encoding::binary};
};

/// Those arrays of points or cells that PLY has room for.
class Columns {
 public:
  /// @param rows  as many as each array must have
  Columns(vtkDataSetAttributes& data, vtkIdType rows, const std::string& kind, PlyText& ply) {
    std::set<std::string> known{"x", "y", "z", "vertex_indices", "vertex_index"};
    for (int a = 0; a < data.GetNumberOfArrays(); ++a) {
      vtkDataArray* array = data.GetArray(a);  // null: text
      std::vector<std::string> names;
      if (array && array->GetNumberOfTuples() >= rows) names = names_of_columns(data, *array, known.contains("red"));
      const bool taken =
          std::any_of(names.begin(), names.end(), [&](const auto& name) { return known.contains(name); });
      if (names.empty() || taken) {
        ply.remark_lost(rows, kind + ' ' + property_name(data.GetAbstractArray(a)->GetName()));
        continue;
      }
      known.insert(names.begin(), names.end());
      arrays_.push_back({array, scalar_type(*array)});
      for (const std::string& name : names) properties_.push_back({name, arrays_.back().type});
    }
  }
  void announce(PlyText& ply) const {
    for (const auto& [name, type] : properties_) ply.property(type, name);
  }
  void put(vtkIdType row, PlyText& ply) const {
    for (const Array& array : arrays_)
      for (int k = 0; k < array.values->GetNumberOfComponents(); ++k)
        ply.value(array.type, array.values->GetComponent(row, k));
  }

 private:
  struct Array {
    vtkDataArray* values;
    ScalarType type;
  };
  std::vector<Array> arrays_;
  std::vector<std::pair<std::string, ScalarType>> properties_;
};

/// Calls use(row of cell data, number of corners, corners) for each polygon, and for each triangle of a strip.
template <class Use>
void for_each_face(vtkPolyData& data, const Use& use) {
  vtkIdType row = data.GetNumberOfVerts() + data.GetNumberOfLines();
  for (const bool strips : {false, true}) {
    vtkCellArray& cells = strips ? *data.GetStrips() : *data.GetPolys();
    for (vtkIdType cell = 0; cell < cells.GetNumberOfCells(); ++cell, ++row) {
      vtkIdType count = 0;
      const vtkIdType* corners = nullptr;
      cells.GetCellAtId(cell, count, corners);
      if (!strips) use(row, count, corners);
      for (vtkIdType k = 0; strips && k + 2 < count; ++k) {
        const std::array<vtkIdType, 3> triangle{corners[k + k % 2], corners[k + 1 - k % 2], corners[k + 2]};
        use(row, 3, triangle.data());
      }
    }
  }
}

/// Here, since the engine would name the place in the PLY file, which no person has.
void require_place(vtkPolyData& data, vtkIdType v) {
  if (v < 0 || v >= data.GetNumberOfPoints())
    throw std::runtime_error("a face names vertex " + std::to_string(v) + ", but there are " +
                             std::to_string(data.GetNumberOfPoints()) + ", from 0 on");
  std::array<double, 3> at{};
  data.GetPoint(v, at.data());
  if (!std::isfinite(at[0]) || !std::isfinite(at[1]) || !std::isfinite(at[2]))
    throw std::runtime_error("vertex " + std::to_string(v) + " has a coordinate that is not finite");
}

void print_as_ply(vtkPolyData& data) {
  if (!data.GetPolys()->IsValid() || !data.GetStrips()->IsValid())
    throw std::runtime_error("the offsets of the faces do not increase, or do not end where their vertices end");
  PlyText ply;
  const vtkIdType points = data.GetNumberOfPoints();
  ply.remark_lost(data.GetNumberOfVerts() + data.GetNumberOfLines(), "cells");
  ply.remark_lost(data.GetFieldData()->GetNumberOfArrays(), "fields");
  const Columns of_points(*data.GetPointData(), points, "vertex", ply);
  const Columns of_faces(*data.GetCellData(), data.GetNumberOfCells(), "face", ply);

  const bool floats = points > 0 && data.GetPoints()->GetDataType() == VTK_FLOAT;
  const ScalarType type = floats ? ScalarType::float32 : ScalarType::float64;
  ply.element("vertex", static_cast<std::size_t>(points));
  for (const char* name : {"x", "y", "z"}) ply.property(type, name);
  of_points.announce(ply);
  for (vtkIdType v = 0; v < points; ++v) {
    std::array<double, 3> at{};
    data.GetPoint(v, at.data());
    for (const double coordinate : at) ply.value(type, coordinate);
    of_points.put(v, ply);
  }

  std::size_t faces = 0;
  for_each_face(data, [&](vtkIdType, vtkIdType, const vtkIdType*) { ++faces; });
  ply.element("face", faces);
  ply.list();
  of_faces.announce(ply);
  for_each_face(data, [&](vtkIdType row, vtkIdType count, const vtkIdType* corners) {
    ply.index(count);
    for (vtkIdType k = 0; k < count; ++k) {
      require_place(data, corners[k]);
      ply.index(corners[k]);
    }
    of_faces.put(row, ply);
  });
  ply.print();
}

// ---- from PLY to VTK ----

std::string array_name(const std::string& property) {
  std::string name;
  for (std::size_t k = 0; k < property.size(); ++k) {
    const std::string code = property[k] == '%' ? property.substr(k + 1, 2) : "";
    if (code.size() == 2 && code.find_first_not_of("0123456789ABCDEF") == std::string::npos) {
      name += static_cast<char>(std::stoi(code, nullptr, 16));
      k += 2;
    } else {
      name += property[k];
    }
  }
  return name;
}

using ColumnList = std::vector<const AttributeColumn*>;

/// Those of the names, in their order, that are there one after the other and of one type.
ColumnList find_columns(const std::vector<AttributeColumn>& columns, const std::vector<std::string>& names) {
  ColumnList found;
  for (const std::string& name : names) {
    const AttributeColumn* column = find_column(columns, name);
    if (!column || column->is_list() || (!found.empty() && column->type() != found.front()->type())) break;
    found.push_back(column);
  }
  return found;
}

vtkSmartPointer<vtkDataArray> array_of(const std::string& name, const ColumnList& columns) {
  const auto array =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(vtk_type(columns.front()->type())));
  array->SetName(name.c_str());
  array->SetNumberOfComponents(static_cast<int>(columns.size()));
  const std::size_t rows = columns.front()->rows();
  array->SetNumberOfTuples(static_cast<vtkIdType>(rows));
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t row = 0; row < rows; ++row)
      array->SetComponent(static_cast<vtkIdType>(row), static_cast<int>(k), columns[k]->value(row));
  return array;
}

void add_arrays(const std::vector<AttributeColumn>& columns, vtkDataSetAttributes& data) {
  std::set<const AttributeColumn*> used;
  const auto take = [&](const char* name, const ColumnList& found) {
    used.insert(found.begin(), found.end());
    return array_of(name, found);
  };
  const ColumnList colors = find_columns(columns, {color_names.begin(), color_names.end()});
  if (colors.size() >= 3 && colors.front()->type() == ScalarType::uint8)
    data.SetScalars(take(colors.size() == 4 ? "RGBA" : "RGB", colors));
  const ColumnList normals = find_columns(columns, {normal_names.begin(), normal_names.end()});
  if (normals.size() == 3) data.SetNormals(take("Normals", normals));
  const ColumnList texture = find_columns(columns, {texture_names.begin(), texture_names.end()});
  if (texture.size() == 2) data.SetTCoords(take("TCoords", texture));
  for (const AttributeColumn& column : columns) {
    if (used.contains(&column) || column.is_list()) continue;
    const std::string& first = column.name();
    std::vector<std::string> names{first};
    const std::string stem = first.substr(0, first.size() - std::min<std::size_t>(2, first.size()));
    for (std::size_t k = 1; !stem.empty() && first.ends_with("_0") && k < columns.size(); ++k)
      names.push_back(stem + "_" + std::to_string(k));
    const ColumnList found = find_columns(columns, names);
    data.AddArray(take(array_name(found.size() > 1 ? stem : first).c_str(), found));
  }
}

vtkSmartPointer<vtkPolyData> polydata_of(const PolygonSoup& soup) {
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(vtk_type(soup.attributes.coordinates));
  points->SetNumberOfPoints(static_cast<vtkIdType>(soup.points.size()));
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    points->SetPoint(static_cast<vtkIdType>(v), soup.points[v].data());
  data->SetPoints(points);
  vtkNew<vtkCellArray> faces;
  for (std::size_t f = 0; f < soup.polygon_count(); ++f) {
    const std::span<const int> polygon = soup.polygon(f);
    faces->InsertNextCell(static_cast<int>(polygon.size()));
    for (const int v : polygon) faces->InsertCellPoint(v);
  }
  data->SetPolys(faces);
  add_arrays(soup.attributes.points, *data->GetPointData());
  add_arrays(soup.attributes.faces, *data->GetCellData());
  return data;
}

void print_as_polydata(const std::string& bytes, bool legacy, bool text) {
  const vtkSmartPointer<vtkPolyData> data = polydata_of(parse_ply({"polydata", bytes}));
  if (legacy) {
    vtkNew<vtkPolyDataWriter> writer;
    writer->SetInputData(data);
    writer->SetFileType(text ? VTK_ASCII : VTK_BINARY);
    writer->WriteToOutputStringOn();
    writer->Write();
    std::cout.write(writer->GetOutputString(), static_cast<std::streamsize>(writer->GetOutputStringLength()));
  } else {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(data);
    if (text) writer->SetDataModeToAscii();
    writer->WriteToOutputStringOn();
    writer->Write();
    std::cout << writer->GetOutputString();
  }
}

}  // namespace
}  // namespace loopmend

int main(int count, char** arguments) {
  using namespace loopmend;
  vtkNew<FirstError> error;
  vtkOutputWindow::SetInstance(error);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  const std::vector<std::string> words(arguments + 1, arguments + count);
  try {
    if (words != std::vector<std::string>{"read"} && words.size() != 2)
      throw std::runtime_error("usage: loopmend-polydata read | legacy|xml binary|text");
    const std::string bytes{std::istreambuf_iterator<char>(std::cin), {}};
    if (words.size() == 2) {
      print_as_polydata(bytes, words[0] == "legacy", words[1] == "text");
    } else {
      const auto data = parsed(bytes);
      if (!error->text().empty()) throw std::runtime_error(error->text());
      print_as_ply(*data);
    }
    if (!error->text().empty()) throw std::runtime_error(error->text());
    if (!std::cout.flush()) throw std::runtime_error("the output cannot be written");
  } catch (const std::bad_alloc&) {
    std::fputs("the file announces more than the memory holds\n", stderr);
    return 3;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 3;
  }
  return 0;
}
