open Scc_calculus
open Scc_semantics
open Scc_property

let fits_name wanted (b : State.bond) =
  match wanted with
  | None -> true
  | Some name -> String.equal name b.name

let fits_ends (wanted : Property.ends) (b : State.bond) =
  let ends p = b.one.at = p || b.two.at = p in
  match wanted with
  | Any -> true
  | One p -> ends p
  | Two (p, q) -> (b.one.at = p && b.two.at = q) || (b.one.at = q && b.two.at = p)

(* Those that bounced are still apart, with the leaves that they had before. *)
let fits_processes (source : State.t) firsts (wanted : Property.ends) =
  let has = State.has_leaf in
  let bounced = List.filter_map (State.home source) firsts in
  let of_one p = List.exists (fun process -> has process p) bounced in
  match wanted with
  | Any -> true
  | One p -> of_one p
  | Two (p, q) -> of_one p && of_one q && not (List.exists (fun process -> has process p && has process q) bounced)

(* The process that is gone is still there, and what took it is there for ever. *)
let fits_absorbed source ~first ~absorber (wanted : Property.ends) =
  let taken p = match State.home source first with Some process -> State.has_leaf process p | None -> false in
  match wanted with
  | Any -> true
  | One p -> p = absorber || taken p
  | Two (p, q) -> (p = absorber && taken q) || (q = absorber && taken p)

let fits_hit (p : Property.spot) q (h : Transition.hit) =
  let is (s : Property.spot) (leaf, part) =
    leaf = s.leaf && match s.part with None -> true | Some k -> k = part
  in
  let both x y = is p x && match q with None -> true | Some q -> is q y in
  both h.one h.two || both h.two h.one

let made : Property.change -> bool = function
  | Made -> true
  | Released_weakly | Released_strongly | Released -> false

let released_weakly : Property.change -> bool = function
  | Released_weakly | Released -> true
  | Made | Released_strongly -> false

let released_strongly : Property.change -> bool = function
  | Released_strongly | Released -> true
  | Made | Released_weakly -> false

let fits_some name ends releases =
  List.exists (fun ({ bond = b; _ } : Transition.release) -> fits_name name b && fits_ends ends b) releases

let matches ~source (label : Transition.label) (event : Property.event) =
  match (event, label) with
  | Bond (change, name, ends), (Bind b | Close b) -> made change && fits_name name b && fits_ends ends b
  | Bond (change, name, ends), Weak_split releases -> released_weakly change && fits_some name ends releases
  | Bond (change, name, ends), Strong_split releases -> released_strongly change && fits_some name ends releases
  | Bounce ends, Bounce { firsts; _ } -> fits_processes source firsts ends
  | Hit (p, q), Bounce { hits; _ } -> List.exists (fits_hit p q) hits
  | Absorbed ends, Absorb { first; absorber } -> fits_absorbed source ~first ~absorber ends
  | Bond _, (Time _ | Bounce _ | Absorb _ | Draw _ | Lot _)
  | (Bounce _ | Hit _), (Time _ | Bind _ | Close _ | Absorb _ | Weak_split _ | Strong_split _ | Draw _ | Lot _)
  | Absorbed _, (Time _ | Bind _ | Close _ | Bounce _ | Weak_split _ | Strong_split _ | Draw _ | Lot _) -> false

let each (label : Transition.label) : Transition.label list =
  match label with
  | Time _ -> []
  | Weak_split releases -> List.map (fun r -> Transition.Weak_split [ r ]) releases
  | Strong_split releases -> List.map (fun r -> Transition.Strong_split [ r ]) releases
  | Bind _ | Close _ | Bounce _ | Absorb _ | Draw _ | Lot _ -> [ label ]
