# SPDX-License-Identifier: GPL-3.0-or-later
# Makes and installs the manual page and the completions of a program, which it prints itself, and the program.
function(add_manual_and_completions name)
  string(TIMESTAMP date "%Y-%m-%d" UTC) # respects SOURCE_DATE_EPOCH
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND ${name} --print-man=${date} > ${name}.1
    COMMAND ${name} --print-completion bash > ${name}.bash
    COMMAND ${name} --print-completion zsh > _${name}
    COMMAND ${name} --print-completion fish > ${name}.fish)
  if(NOT POINT_SET_FLOW_INSTALL)
    return()
  endif()
  set_property(TARGET ${name} PROPERTY INSTALL_RPATH_USE_LINK_PATH ON) # libraries in odd places
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} OPTIONAL)
  set(made ${CMAKE_CURRENT_BINARY_DIR})
  install(FILES ${made}/${name}.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
  install(FILES ${made}/${name}.bash RENAME ${name}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions OPTIONAL)
  install(FILES ${made}/_${name} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions OPTIONAL)
  install(FILES ${made}/${name}.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d OPTIONAL)
endfunction()
