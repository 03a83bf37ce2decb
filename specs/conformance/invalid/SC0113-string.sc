// the name of a file: it is written out wherever it is told
process p = mesh "open⁧.off⁩" mass 1 [nil]
