(** The broad phase for boxes that are all known at once. *)

open Scc_geometry

val pairs : Float_box.t array -> (int * int) list
(** [pairs boxes] is the list of exactly those (i, j) with i < j whose boxes {!Scc_geometry.Float_box.meet}, in
    lexicographic order. *)
