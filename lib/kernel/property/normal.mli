(** One form of predicates and numbers that differ in the way in which they are written: what is added and
    subtracted, multiplied by constants, and joined by [and], [or], [count] in any order. *)

open Property

val prop : prop -> prop
(** [prop p] is [p] with each comparison as one of a linear combination with a constant, in {!Rename.ordered_prop}
    form. It is equivalent to [p], and undefined in the same states. Equal forms therefore mean the same;
    predicates may mean the same and have other forms. *)

val num : num -> num
(** [num n] is [n] as a linear combination, in ordered form. It is equal to [n] wherever [n] is defined, and
    defined in the same states. *)
