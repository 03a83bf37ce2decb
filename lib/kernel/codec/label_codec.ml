open Scc_semantics

let time = 0
let bind = 1
let close = 2
let bounce = 3
let absorb = 4
let weak_split = 5
let strong_split = 6
let draw = 7
let lot = 8
let draw_with_spin = 9

let put_release codec buffer (r : Transition.release) =
  State_codec.put_bond codec buffer r.bond;
  Packed.put_rational buffer r.push

let put_place buffer (leaf, part) =
  Packed.put_nat buffer leaf;
  Packed.put_nat buffer part

let put_hit buffer (h : Transition.hit) =
  put_place buffer h.one;
  put_place buffer h.two

let decision (d : Transition.decision) = match d with Kept -> 0 | Let_go -> 1 | First -> 2 | Chosen -> 3

let put codec b (l : Transition.label) =
  match l with
  | Time d ->
    Packed.put_nat b time;
    Packed.put_rational b d
  | Bind bond ->
    Packed.put_nat b bind;
    State_codec.put_bond codec b bond
  | Close bond ->
    Packed.put_nat b close;
    State_codec.put_bond codec b bond
  | Bounce { firsts; hits } ->
    Packed.put_nat b bounce;
    Packed.put_list b Packed.put_nat firsts;
    Packed.put_list b put_hit hits
  | Absorb { first; absorber } ->
    Packed.put_nat b absorb;
    Packed.put_nat b first;
    Packed.put_nat b absorber
  | Weak_split releases ->
    Packed.put_nat b weak_split;
    Packed.put_list b (put_release codec) releases
  | Strong_split releases ->
    Packed.put_nat b strong_split;
    Packed.put_list b (put_release codec) releases
  | Draw { first; given = { velocity; spin }; chance } ->
    Packed.put_nat b (if Option.is_none spin then draw else draw_with_spin);
    Packed.put_nat b first;
    Packed.put_vector b velocity;
    Option.iter (Packed.put_vector b) spin;
    Packed.put_rational b chance
  | Lot { bond; decision = d; chance } ->
    Packed.put_nat b lot;
    State_codec.put_bond codec b bond;
    Packed.put_nat b (decision d);
    Packed.put_rational b chance

let place source =
  let leaf = Packed.nat source in
  (leaf, Packed.nat source)

let hit source =
  let one = place source in
  { Transition.one; two = place source }

let release codec source =
  let bond = State_codec.bond codec source in
  { Transition.bond; push = Packed.rational source }

let read codec s : Transition.label =
  let kind = Packed.below (draw_with_spin + 1) ~what:"the kind of transition" s in
  if kind = time then Time (Packed.rational s)
  else if kind = bind then Bind (State_codec.bond codec s)
  else if kind = close then Close (State_codec.bond codec s)
  else if kind = bounce then
    let firsts = Packed.list s Packed.nat in
    Bounce { firsts; hits = Packed.list s hit }
  else if kind = absorb then
    let first = Packed.nat s in
    Absorb { first; absorber = Packed.nat s }
  else if kind = weak_split then Weak_split (Packed.list s (release codec))
  else if kind = strong_split then Strong_split (Packed.list s (release codec))
  else if kind = draw || kind = draw_with_spin then
    let first = Packed.nat s in
    let velocity = Packed.vector s in
    let spin = if kind = draw then None else Some (Packed.vector s) in
    Draw { first; given = { velocity; spin }; chance = Packed.rational s }
  else
    let bond = State_codec.bond codec s in
    let decision : Transition.decision =
      match Packed.below 4 ~what:"the decision" s with
      | 0 -> Kept
      | 1 -> Let_go
      | 2 -> First
      | _ -> Chosen
    in
    Lot { bond; decision; chance = Packed.rational s }
