(** A sweep as a chart. *)

val axes : Grid.t -> (string list, string) result
(** The names of the parameters with several values, if there are one or two. The error is the reason why no
    chart is drawn. *)

val chart : title:string -> Grid.t -> Outcome.t array -> string
(** An SVG document. A check that requests a number is a curve over one parameter, with uncertainty as a band.
    All others, and all checks over two parameters, are cells with the colour of the verdict or of the
    number. *)
