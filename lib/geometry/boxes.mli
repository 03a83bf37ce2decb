(** The broad phase: which of many boxes with edges along the axes meet. *)

open Scc_exact

val swept : Vec.t * Vec.t -> Vec.t -> Vec.t * Vec.t
(** [swept (low, high) d] is the least box that holds the box at every place on its way along the
    displacement [d]. *)

val meet : Vec.t * Vec.t -> Vec.t * Vec.t -> bool
(** Whether two closed boxes, each given by its least and its greatest corner, have a point in common. *)

val pairs : (Vec.t * Vec.t) array -> (int * int) list
(** [pairs boxes]: every (i, j) with i < j whose closed boxes {!meet}, and no other, in lexicographic order. *)
