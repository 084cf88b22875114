# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the package, and moves it afterwards: it must work from where it is.
file(REMOVE_RECURSE ${WORK_DIR})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/elsewhere
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${WORK_DIR}/elsewhere ${WORK_DIR}/prefix)
