(** The broad phase for boxes that are all there at once: which of them meet. *)

open Scc_geometry

val pairs : Float_box.t array -> (int * int) list
(** [pairs boxes]: every (i, j) with i < j whose boxes {!Float_box.meet}, and no other, in lexicographic order. *)
