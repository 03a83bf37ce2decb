(** Fixed points over all states by passes, up and down by turns. States are numbered in the order of exploration,
    so that a few passes suffice as a rule. Passes read the branches one after the other, whereas a backward search
    jumps. *)

val run : size:int -> (int -> bool) -> bool
(** [run ~size look] calls [look] for each number below [size] in repeated passes; [look i] is true if it changed
    something. The result is true if the last pass changed nothing. It is false if passes were given up: after 64
    passes, when one changes at most a sixteenth of the numbers. So the time is that of a bounded number of passes.
*)
