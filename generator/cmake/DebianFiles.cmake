# Run by CPack on the installed files, before it packs them: makes usr/share/doc and the manual pages as Debian's policy wants them.
# The environment variable SOURCE_DATE_EPOCH is the date of the release.
file(GLOB manual_pages ${CPACK_TEMPORARY_DIRECTORY}/symplant/usr/share/man/man1/*.1)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(package IN LISTS CPACK_COMPONENTS_ALL)
  set(doc ${CPACK_TEMPORARY_DIRECTORY}/${package}/usr/share/doc/${package})
  file(COPY_FILE ${CPACK_TEMPORARY_DIRECTORY}/symplant/usr/share/doc/symplant/CHANGELOG.md ${doc}/changelog)
  file(WRITE ${doc}/changelog.Debian
       "symplant (${CPACK_PACKAGE_VERSION}-1) unstable; urgency=medium\n\n"
       "  * Version ${CPACK_PACKAGE_VERSION}. Its changes: changelog.gz\n\n"
       " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  if(NOT package STREQUAL symplant)
    file(COPY_FILE ${CPACK_TEMPORARY_DIRECTORY}/symplant/usr/share/doc/symplant/copyright ${doc}/copyright)
  endif()
  list(APPEND packed ${doc}/changelog ${doc}/changelog.Debian)
endforeach()
file(REMOVE ${CPACK_TEMPORARY_DIRECTORY}/symplant/usr/share/doc/symplant/CHANGELOG.md)
execute_process(COMMAND gzip -9n ${manual_pages} ${packed} COMMAND_ERROR_IS_FATAL ANY)
