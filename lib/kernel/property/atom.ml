open Scc_calculus
open Property

type argument =
  | Leaf of int
  | Channel of Behaviour.polarity option * string
  | Definition of int
  | Part of int * int
  | Parameter of int

type aspect = Absolute_time | Absolute_place | Motion | Speed | Structure | Bonding | Term | Split_clock
type scope = Named | Whole
type change = Never | Turning | Always

type t = {
  word : string;
  arguments : argument list;
  symmetric : bool;
  scope : scope;
  aspects : aspect list;
  change : change;
  event : event option;
  total : quantity option;
}

let leaf i = [ Leaf i ]
let two (i, j) = [ Leaf i; Leaf j ]
let channel name = List.map (fun a -> Channel (None, a)) (Option.to_list name)

let axis = function
  | X -> "x"
  | Y -> "y"
  | Z -> "z"

let change_word = function
  | Made -> "bind"
  | Released_weakly -> "weak"
  | Released_strongly -> "strong"
  | Released -> "split"

let of_ends = function
  | Any -> []
  | One i -> leaf i
  | Two (i, j) -> two (i, j)

let event_word = function
  | Bond (change, _, _) -> change_word change
  | Bounce _ -> "bounce"
  | Absorbed _ -> "absorb"
  | Hit _ -> "hit"

let spot { leaf; part } = match part with None -> Leaf leaf | Some k -> Part (leaf, k)

let event_arguments = function
  | Hit (p, q) -> spot p :: List.map spot (Option.to_list q)
  | Bond (_, name, ends) -> channel name @ of_ends ends
  | Bounce ends | Absorbed ends -> of_ends ends

let event_scope = function
  | Bond (_, _, Any) | Bounce Any | Absorbed Any -> Whole
  | Bond (_, _, (One _ | Two _)) | Bounce (One _ | Two _) | Absorbed (One _ | Two _) | Hit _ -> Named

(* {1 The table}

   Each row says everything, so that whoever adds one has thought of everything. *)

let row ?(symmetric = false) word arguments scope aspects change =
  { word; arguments; symmetric; scope; aspects; change; event = None; total = None }

let total quantity row = { row with total = Some quantity }

let symmetric = true

(* Parts do not change places with their leaves. *)
let is_symmetric = function
  | Hit (p, q) -> Option.is_none p.part && Option.is_none (Option.bind q (fun q -> q.part))
  | Bond _ | Bounce _ | Absorbed _ -> true

let quantity q =
  match q with
  | Bonds (None, None) -> total q (row "bonds()" [] Whole [ Bonding ] Never)
  | Bonds ((Some _ as name), None) -> total q (row "bonds" (channel name) Whole [ Bonding ] Never)
  | Bonds (name, Some ends) -> row "bonds" (channel name @ two ends) Named [ Bonding ] Never ~symmetric
  | Size i -> row "size" (leaf i) Named [ Structure ] Never
  | Processes -> total q (row "processes" [] Whole [ Structure ] Never)
  | Position (a, i) -> row (axis a) (leaf i) Named [ Absolute_place; Motion ] Always
  | Velocity (a, i) -> row ("v" ^ axis a) (leaf i) Named [ Motion; Speed ] Turning
  | Speed2 i -> row "speed2" (leaf i) Named [ Motion; Speed ] Turning
  | Spin (a, i) -> row ("w" ^ axis a) (leaf i) Named [ Motion; Speed ] Turning
  | Spin2 i -> row "spin2" (leaf i) Named [ Motion; Speed ] Turning
  | Distance2 (i, j) -> row "distance2" (two (i, j)) Named [ Motion ] Always ~symmetric
  | Momentum a -> row ("momentum." ^ axis a) [] Whole [ Motion; Speed ] Never
  | Angular a -> row ("angular." ^ axis a) [] Whole [ Absolute_place; Motion; Speed ] Turning
  | Energy -> row "energy" [] Whole [ Motion; Speed ] Turning
  | Time -> row "time" [] Named [ Absolute_time ] Always
  | Parameter i -> row "parameter" [ Parameter i ] Named [] Never

let fact = function
  | Bound (i, j) -> row "bound" (two (i, j)) Named [ Bonding ] Never ~symmetric
  | Same (i, j) -> row "same" (two (i, j)) Named [ Structure ] Never ~symmetric
  | Behaviour (i, k) -> row "behaviour" (leaf i @ [ Definition k ]) Named [ Term ] Never
  | Offers (i, polarity, a) -> row "offers" (leaf i @ [ Channel (polarity, a) ]) Named [ Term ] Never
  | Touching (i, j) -> row "touching" (two (i, j)) Named [ Motion ] Always ~symmetric
  | Gone i -> row "gone" (leaf i) Named [ Structure ] Never
  | Quiescent -> row "quiescent" [] Whole [ Motion; Speed; Structure; Term; Split_clock ] Never
  | Event e ->
    let symmetric = is_symmetric e in
    let written = row ("event " ^ event_word e) (event_arguments e) (event_scope e) [] Never ~symmetric in
    { written with event = Some e }

let leaves t =
  List.filter_map
    (function
      | Leaf i | Part (i, _) -> Some i
      | Channel _ | Definition _ | Parameter _ -> None)
    t.arguments

let depends_on aspect t = List.mem aspect t.aspects

let steady ~rigid t =
  match t.change with
  | Never -> true
  | Turning -> not rigid
  | Always -> false

let compare a b = compare (a.word, a.arguments) (b.word, b.arguments)

(* {1 Other leaves} *)

let renamed_quantity f = function
  | (Processes | Momentum _ | Angular _ | Energy | Time | Parameter _ | Bonds (_, None)) as q -> q
  | Bonds (a, Some (i, j)) -> Bonds (a, Some (f i, f j))
  | Size i -> Size (f i)
  | Position (a, i) -> Position (a, f i)
  | Velocity (a, i) -> Velocity (a, f i)
  | Speed2 i -> Speed2 (f i)
  | Spin (a, i) -> Spin (a, f i)
  | Spin2 i -> Spin2 (f i)
  | Distance2 (i, j) -> Distance2 (f i, f j)

let renamed_ends f = function
  | Any -> Any
  | One i -> One (f i)
  | Two (i, j) -> Two (f i, f j)

let renamed_spot f s = { s with leaf = f s.leaf }

let renamed_event f = function
  | Hit (p, q) -> Hit (renamed_spot f p, Option.map (renamed_spot f) q)
  | Bond (change, a, ends) -> Bond (change, a, renamed_ends f ends)
  | Bounce ends -> Bounce (renamed_ends f ends)
  | Absorbed ends -> Absorbed (renamed_ends f ends)

let renamed_fact f = function
  | Bound (i, j) -> Bound (f i, f j)
  | Same (i, j) -> Same (f i, f j)
  | Behaviour (i, k) -> Behaviour (f i, k)
  | Offers (i, p, a) -> Offers (f i, p, a)
  | Touching (i, j) -> Touching (f i, f j)
  | Gone i -> Gone (f i)
  | Quiescent -> Quiescent
  | Event e -> Event (renamed_event f e)
