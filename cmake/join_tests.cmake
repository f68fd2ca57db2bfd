# cmake -DOUT=FILE -DFIRST=N -DSOURCES=A,B,... -P join_tests.cmake: writes one source of several tests', which share the
# parsing of headers and what templates they instantiate: a quarter of the time to compile. Their unnamed namespaces are
# named here, by a number from FIRST up, so that none sees another's; lines keep their names in messages.
string(REPLACE "," ";" sources "${SOURCES}")
set(joined "")
foreach(source IN LISTS sources)
  file(READ ${source} text)
  string(REPLACE "\nnamespace {\n" "\nnamespace tests_${FIRST} {\n" text "${text}")
  string(APPEND joined "#line 1 \"${source}\"\n${text}")
  math(EXPR FIRST "${FIRST} + 1")
endforeach()
file(WRITE ${OUT} "${joined}")
