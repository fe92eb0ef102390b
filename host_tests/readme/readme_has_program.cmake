# Fails unless the README holds the program word for word.
file(READ ${README} readme)
file(READ ${PROGRAM} program)
string(FIND "${readme}" "${program}" at)
if(at EQUAL -1)
    message(FATAL_ERROR "README.md does not hold ${PROGRAM} word for word")
endif()
