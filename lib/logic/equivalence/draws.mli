(** What is drawn at one instant, as one transition. Draws and lots come one after the other, in an order that says
    nothing (rules Draw and Lot, law Impartiality): all that is seen of them is what has been drawn in the end, and
    with which probability. *)

val joined : told:(string -> string) -> Graph.t -> Graph.t
(** The graph with its labels as they are [told], {!Graph.tau} for those that are not to be seen. At a state of
    which all transitions have a chance ({!Label.chance}) stand, instead of them, the ways through such states to
    the first that is none: [{keep(b, e, e'), release(a, e, e')} chance(1/6)], with what is drawn on the way in the
    order of the texts, and with the product of the chances. What is not to be seen is left out. Of two ways with
    one label to one state the chances add. Where something is only chosen ([choose(...)]) stands what follows the
    choices.

    A state from which some way leads to one that is not known has transitions that are not known. Draws that may
    go round for ever stay as they are. *)
