(** Boxes along the axes, as closed sets of positive volume. *)

open Scc_exact

type t = { low : Vec.t; high : Vec.t }
(** The points between two opposite corners: each coordinate of [low] is less than that of [high]. *)

val corners : t -> Vec.t list
(** The eight corners of a box. *)

val cover : t list -> t -> bool
(** [cover boxes b] is true if each point of [b] is in one of [boxes]. *)
