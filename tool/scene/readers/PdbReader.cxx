// SPDX-FileCopyrightText: Penumbra authors
// SPDX-License-Identifier: BSD-3-Clause
// Protein Data Bank files. VTK's reader looks for an atom's element at the end of its line, where old files have other text,
// so every atom gets a wrong element. Its positions and arrays are used, and elements are read here.
#include "common/Failure.h"
#include "common/Names.h"
#include "scene/readers/FormatReaders.h"

#include <vtkDataSetAttributes.h>
#include <vtkMolecule.h>
#include <vtkPDBReader.h>
#include <vtkPeriodicTable.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cctype>
#include <fstream>

namespace penumbra::tool
{
namespace
{
constexpr unsigned short Carbon = 6;

/// The number of an element, such as 17 for "CL"; 0 if it does not exist.
unsigned short ElementNumber(vtkPeriodicTable* table, std::string symbol)
{
  for (std::size_t i = 0; i < symbol.size(); ++i)
  {
    const unsigned char letter = static_cast<unsigned char>(symbol[i]);
    if (!std::isalpha(letter))
    {
      return 0;
    }
    symbol[i] = static_cast<char>(i == 0 ? std::toupper(letter) : std::tolower(letter));
  }
  return symbol.empty() ? 0 : table->GetAtomicNumber(symbol);
}

std::string Columns(const std::string& line, std::size_t first, std::size_t count)
{
  return first < line.size() ? Trim(line.substr(first, count)) : "";
}

/// wwPDB 2012, Atomic Coordinate Entry Format 3.3: columns 77 and 78 hold the element. In older files it is only in the
/// atom's name, right-aligned in columns 13 and 14.
unsigned short ElementOfLine(vtkPeriodicTable* table, const std::string& line)
{
  const std::string name = Columns(line, 12, 4);
  const auto letter = name.find_first_not_of("0123456789'\"*");
  const std::string first = letter == std::string::npos ? "" : name.substr(letter, 1);
  const unsigned short stated = ElementNumber(table, Columns(line, 76, 2));
  if (stated > 0 && !first.empty())
  {
    return stated;
  }
  const bool hetero = line.rfind("HETATM", 0) == 0;
  const std::string aligned = line.size() > 14 && line[12] != ' ' ? line.substr(12, 2) : "";
  const unsigned short two = hetero ? ElementNumber(table, aligned) : 0;
  return two > 0 ? two : ElementNumber(table, first);
}

std::vector<unsigned short> ReadElements(const std::string& path, vtkPeriodicTable* table)
{
  std::vector<unsigned short> elements;
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line))
  {
    if (line.rfind("ATOM", 0) == 0 || line.rfind("HETATM", 0) == 0)
    {
      constexpr std::size_t endOfCoordinates = 54;
      if (line.size() < endOfCoordinates)
      {
        Fail("'{}' is damaged or cut off: the line of atom {} ends before its coordinates do", path,
          elements.size() + 1);
      }
      elements.push_back(ElementOfLine(table, line));
    }
  }
  return elements;
}
}

LoadedData ReadPdb(const std::string& path, Step& step)
{
  vtkNew<vtkPDBReader> reader;
  reader->SetFileName(path.c_str());
  step.Observe(reader);
  reader->Update();
  vtkPolyData* atoms = reader->GetOutput();
  vtkNew<vtkPeriodicTable> table;
  const std::vector<unsigned short> elements = ReadElements(path, table);
  vtkNew<vtkMolecule> molecule;
  vtkIdType unknown = 0;
  for (vtkIdType i = 0; i < atoms->GetNumberOfPoints(); ++i)
  {
    // The reader stops at END. Up to there the order is the same.
    const std::size_t index = static_cast<std::size_t>(i);
    const unsigned short element = index < elements.size() ? elements[index] : 0;
    unknown += element == 0 ? 1 : 0;
    const double* position = atoms->GetPoint(i);
    molecule->AppendAtom(element > 0 ? element : Carbon, position[0], position[1], position[2]);
  }
  if (unknown > 0)
  {
    step.Note(
      fmt::format("{} atoms of '{}' have unknown elements and are drawn as carbon", unknown, path));
  }
  for (int i = 0; i < atoms->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = atoms->GetPointData()->GetAbstractArray(i);
    if (array->GetNumberOfTuples() == molecule->GetNumberOfAtoms())
    {
      molecule->GetAtomData()->AddArray(array);
    }
  }
  LoadedData loaded;
  loaded.Kind = Content::Molecule;
  loaded.Data = molecule.GetPointer();
  return loaded;
}
}
