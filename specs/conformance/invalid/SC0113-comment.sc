// what a comment hides: each line that has such characters, and all lines of a comment (a warning)
process p = box(1, 1, 1) mass 1 velocity (1, 0, 0) [nil] /* begin ‮ } ⁦ end */
// ‪a‫ b ‬‭
/* a comment
   of two lines, one with ⁩ */
// Latin, ‎‏؜ marks, العربية: nothing to say
fixed q = box(1, 1, 1) at translate (5, 0, 0)
check meets : eventually event bounce
