module Numbers = Map.Make (struct
    type t = Property.prop

    let compare = Order.prop
  end)

let of_temporal formulas =
  let numbers = ref Numbers.empty and found = ref [] and count = ref 0 in
  let number p =
    match Numbers.find_opt p !numbers with
    | Some k -> k
    | None ->
      let k = !count in
      incr count;
      numbers := Numbers.add p k !numbers;
      found := p :: !found;
      k
  in
  let rec go (f : Property.temporal) : Scc_ctl.Timed_formula.t =
    match f with
    | State p -> Predicate (number p)
    | Temporal_not f -> Not (go f)
    | Temporal_and l -> And (List.map go l)
    | Temporal_or l -> Or (List.map go l)
    | Next (q, f) -> Next (q, go f)
    | Finally (q, b, f) -> Finally (q, b, go f)
    | Globally (q, b, f) -> Globally (q, b, go f)
    | Until (q, b, f, g) ->
      let f = go f in
      Until (q, b, f, go g)
  in
  let formulas = List.map go formulas in
  (formulas, Array.of_list (List.rev !found))

let rec to_temporal prop (f : Scc_ctl.Timed_formula.t) : Property.temporal =
  let go = to_temporal prop in
  match f with
  | Predicate k -> State (prop k)
  | Not f -> Temporal_not (go f)
  | And fs -> Temporal_and (List.map go fs)
  | Or fs -> Temporal_or (List.map go fs)
  | Next (q, f) -> Next (q, go f)
  | Finally (q, b, f) -> Finally (q, b, go f)
  | Globally (q, b, f) -> Globally (q, b, go f)
  | Until (q, b, f, g) -> Until (q, b, go f, go g)
