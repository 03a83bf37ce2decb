// the name of a file that XML cannot hold
import "ab.sc"
