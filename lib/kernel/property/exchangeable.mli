(** Which leaves may change places in a formula, but for the order of what it joins. *)

type t

val make : Property.temporal -> t
(** What {!are} looks at, found once. *)

val are : t -> int -> int -> bool
(** Whether the formula with the two leaves in each other's place is {!Formula.equal_modulo_order}. Of what [and],
    [or], [count], [+] and [*] join, only that is looked at which names one of the two. *)
