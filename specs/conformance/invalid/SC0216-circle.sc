// an import that leads back to itself
import "circle.inc" (Cube)
process p = Cube mass 1 [nil]
