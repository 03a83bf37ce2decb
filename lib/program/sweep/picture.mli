(** A sweep as a chart. *)

val axes : Grid.t -> (string list, string) result
(** The names of the parameters that have several values: one or two. Otherwise why nothing is drawn. *)

val chart : title:string -> Grid.t -> Outcome.t array -> string
(** An SVG document: for each check that asks for a number a curve over one parameter, with what is not known as a
    band; for all others, and over two parameters, cells with the colour of the verdict, or of the number. *)
