(** Which bodies look alike to a person, and so have one colour in pictures: those that are named alike but for an
    index ([p[1]], [p2]); where the bodies that move have more than ten such names, those of one template. *)

type t = {
  names : string array;  (** those of bodies that move come first, in the order of the model *)
  of_leaf : int array;  (** for each leaf, an index into [names] *)
}

val of_model : Model.t -> t
