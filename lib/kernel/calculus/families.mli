(** Families of bodies that have one colour in pictures. Bodies are of one family if their names differ in an index
    alone ([p[1]], [p2]). If the bodies that move have more than ten such names, a family is a template. *)

type t = {
  names : string array;
  (** the names of the families; those of bodies that move come first, in the order of the model *)
  of_leaf : int array;  (** the family of each leaf, as an index into [names] *)
}

val of_model : Model.t -> t
(** [of_model m] is the families of all leaves of [m], fixed ones included. *)
