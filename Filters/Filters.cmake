# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# Sources and filters, one class a line.
set(BRAVAIS_FILTERS
  vtkBCCVolumeSource
)
