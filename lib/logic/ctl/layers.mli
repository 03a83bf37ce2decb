(** The probability of "f until g" within a window of time that ends: the places of {!Decisions}, layer by layer. A
    layer is the places that are entered at one time. Time passes from a layer to later ones only, so the values of
    a layer follow from those of later layers, from the last one back. Values are kept of the layers only that are
    still needed.

    It works if no run comes back to a node in no time. Otherwise a layer would be a system of equations. *)

open Scc_chance

type t
(** The layers of the places that can be reached from some starts. *)

val make : Decisions.question -> Decisions.window -> Decisions.next list -> t option
(** [make q w starts] is the layers of all places that can be reached from the starts. It is [None] if the window
    has no end, or if some of these runs may come back to a node in no time. *)

type values

val value : values -> Decisions.next -> Answer.t
(** [value v next] is the probability from one of the starts: [Exact] or [Within]. *)

val solve : t -> Effort.t -> values
(** [solve t effort] is the probabilities of all starts. With the engine [Either] they are exact if no number is
    longer than the effort allows, and otherwise an interval of which both ends were rounded outwards
    ({!Arithmetic.rounded}). They are from 0 to 1 if the computation was interrupted. *)

val run : t -> Effort.t -> Decisions.next -> (Decisions.place * Decisions.branch) list option
(** [run t effort start] is a run from one of the starts to [Goal] with the fewest steps: each place with the branch
    taken there, in order. It takes choices that attain the probability. It is [None] if none leads to [Goal]. *)

val arrivals : t -> Timeline.moment list
(** [arrivals t] is the times at which some run from a start may meet g, increasing, each once. Times are elapsed
    times, as those of places. *)
