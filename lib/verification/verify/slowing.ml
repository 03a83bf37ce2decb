open Scc_exact
open Scc_state_space
module Graph = State_graph

type stretch = { instants : int; took : Rat.t }
type t = { stretches : stretch list; until : Rat.t }

let fewest = 24

(* The last come first, each once; a state may have been reached earlier than the one before it on the path. *)
let rec distinct found = function
  | [] -> found
  | t :: rest -> (
      match found with
      | last :: _ when Rat.compare t last <= 0 -> distinct found rest
      | _ -> distinct (t :: found) rest)

(* The third instant counts from the last, the second and the first each half as far from the start: gaps that fall
   as 1/n take equal times in such stretches, and constant ones the double each time. *)
let of_instants times =
  let all = Array.of_list (List.rev (distinct [] times)) in
  let n = Array.length all - 1 in
  if n < fewest then None
  else
    let stretch from until = { instants = until - from; took = Rat.sub all.(until) all.(from) } in
    let a = stretch (n / 8) (n / 4) and b = stretch (n / 4) (n / 2) and c = stretch (n / 2) n in
    let less x y = Rat.compare (Rat.mul (Rat.of_int 4) y.took) (Rat.mul (Rat.of_int 3) x.took) <= 0 in
    if less a b && less b c then Some { stretches = [ a; b; c ]; until = all.(n) } else None

let is_bound : _ Scc_graph_search.Explore.reason -> bool = function
  | Depth | States | Bits | Seconds | Memory | Interrupted -> true
  | Time | Instant | Stopped | Fault _ -> false

let deepest graph =
  let deeper best (i, reason) =
    match best with
    | _ when not (is_bound reason) -> best
    | Some j when Graph.depth graph j >= Graph.depth graph i -> best
    | Some _ | None -> Some i
  in
  Seq.fold_left deeper None (Graph.unexpanded graph)

let find graph =
  let instants i = List.map (Graph.arrival graph) (Graph.ancestors graph i) in
  Option.bind (deepest graph) (fun i -> of_instants (instants i))

let to_string s =
  let stretch x = Printf.sprintf "%d instants took %s" x.instants (Decimal.significant ~digits:3 x.took) in
  Printf.sprintf "event times grow ever slower: %s, up to time %s"
    (String.concat ", the next " (List.map stretch s.stretches))
    (Decimal.significant ~digits:6 s.until)
