(** Sets of states that grow until nothing changes, found by looking at all states in turn, up and down. Models are
    numbered as they are explored, so that a few such passes find all as a rule; and they read the branches one
    after the other, where a search backwards jumps. *)

val run : size:int -> (int -> bool) -> bool
(** [run ~size look] looks at each number below the size again and again; [look] tells whether that changed
    anything. Whether nothing changes any more: it is given up when passes are many and change little, so that the
    time is that of a bounded number of passes. *)
