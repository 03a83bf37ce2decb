(** Arrays gone through in an order that comes from everywhere. *)

val iter : ('a -> unit) -> 'a array -> unit
(** Each element once. The first ones to come are from everywhere: what comes in rows makes a bad start for a tree
    that is built one by one, and has long nodes near its root, for ever. *)
