(** Probabilities, means and runs, computed layer by layer ({!Layers}): the values of a layer follow from those of
    later layers, from the last one back. Values are kept of the layers only that are still needed. *)

open Scc_chance

type values

val value : values -> Decisions.next -> Answer.t
(** [value v next] is the probability, or the mean, from one of the starts: [Exact] or [Within]. *)

val solve : Layers.t -> Effort.t -> values
(** [solve t effort] is the probabilities of all starts, or the means of {!Layers.means}, where each run from them
    ends with a reward. With the engine [Either] they are exact if no number is longer than the effort allows.
    Otherwise each is an interval, of which both ends were rounded outwards ({!Arithmetic.rounded}). If the
    computation was interrupted, they are from 0 to 1, or from the least reward to the greatest. *)

val run : Layers.t -> Effort.t -> Decisions.next -> (Decisions.place * Decisions.branch) list option
(** [run t effort start] is a run from one of the starts to [Goal] with the fewest steps: each place with the
    branch that is taken there, in order. It takes choices that attain the probability. It is [None] if none leads
    to [Goal]. *)
