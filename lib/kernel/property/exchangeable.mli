(** Which leaves may change places in a formula, but for the order of what it joins. *)

(** A formula, prepared for {!are}. *)
type t

val make : Property.temporal -> t
(** Prepares a formula, once for all pairs of leaves. *)

val are : t -> int -> int -> bool
(** [are f p q] is true if exchanging the leaves [p] and [q] gives a formula with the same {!Rename.ordered} form.
    In what [and], [or], [count], [+] and [*] join, only the parts that name [p] or [q] are compared. *)
