open Scc_calculus
open Scc_semantics

type context = { model : Model.t; initial : State.t }
type state = State.t
type transition = Transition.t
type fault = Transition.fault

let initial c = c.initial
let successors c s = Network.successors c.model s
let target (t : Transition.t) = t.target
let duration = Transition.duration
let equal = State.equal
let hash = State.hash
