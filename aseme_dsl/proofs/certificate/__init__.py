"""Certificate of the compiler: each statechart is exactly what its formula and its control lines say."""
