(** Draws and lots of one instant, joined into one transition. They come one after the other, in an order without
    meaning (rules Draw and Lot, law Impartiality). Only their result and its probability can be observed. *)

val joined : told:(string -> string) -> Graph.t -> Graph.t
(** [joined ~told g] is [g] with each label replaced by its image under [told], and with its draws joined. The
    image is {!Graph.tau} for labels that are not observed. Unreachable states are dropped if any state draws or
    chooses.

    A state draws if all of its transitions have a chance ({!Label.chance}). They are replaced by the ways through
    states that draw, to the first state that does not. The label of a way has its draws, sorted as texts, and the
    product of their chances: [{keep(b, e, e'), release(a, e, e')} chance(1/6)]. Draws with the image {!Graph.tau}
    are left out of the text, but their chances count. The label has no chance if [told] removes that of a draw in
    the text. The chances of two ways with one label and one target add up.

    A state chooses if all of its transitions are [choose(...)]. They are replaced by the transitions that follow
    all choices, if these are weak splits.

    A state from which some way leads to an unknown state is unknown. Draws that may go round for ever stay as they
    are. *)
