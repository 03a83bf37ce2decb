open Scc_exact
open Scc_svg

let several (grid : Grid.t) = List.filter (fun (a : Grid.axis) -> Array.length a.values > 1) grid

let axes grid =
  match several grid with
  | ([ _ ] | [ _; _ ]) as axes -> Ok (List.map (fun (a : Grid.axis) -> a.name) axes)
  | [] -> Error "a chart is drawn over one or two parameters that have several values, and none has"
  | _ -> Error "a chart is drawn over one or two parameters that have several values, and more have"

let found name outcome =
  List.find_opt (fun (c : Outcome.check) -> String.equal c.name name) (Outcome.checks outcome)

(* In the order in which they come first. *)
let names outcomes =
  let add names (o : Outcome.t) =
    let new_ (c : Outcome.check) = not (List.mem c.name names) in
    names @ List.map (fun (c : Outcome.check) -> c.name) (List.filter new_ (Outcome.checks o))
  in
  Array.fold_left add [] outcomes

(* Of all schedulers, from the least to the greatest. *)
let range (c : Outcome.check) =
  match c.numbers with
  | [] -> None
  | n :: rest -> (
      let last = List.fold_left (fun _ m -> m) n rest in
      match (n.low, last.high) with
      | Some low, Some high when not (n.infinite || last.infinite) -> Some (low, high)
      | _, _ -> None)

let middle (low, high) = Rat.middle low high

let curve (axis : Grid.axis) outcomes name : Chart.panel =
  let add i pieces =
    match (Option.bind (found name outcomes.(i)) range, pieces) with
    | None, _ -> [] :: pieces
    | Some r, piece :: rest ->
      ({ Chart.x = axis.values.(i); y = middle r; band = Some r } :: piece) :: rest
    | Some r, [] -> [ [ { Chart.x = axis.values.(i); y = middle r; band = Some r } ] ]
  in
  let rec from i pieces = if i < 0 then pieces else from (i - 1) (add i pieces) in
  let pieces = List.filter (fun p -> p <> []) (from (Array.length outcomes - 1) []) in
  { title = name; curves = [ { name = ""; pieces } ] }

let cell name outcome : Chart.cell =
  match (outcome : Outcome.t) with
  | Refused { code; message } -> { said = Printf.sprintf "%s: %s" code message; amount = Nothing }
  | Checked _ -> (
      match found name outcome with
      | None -> { said = "there is no such check"; amount = Nothing }
      | Some c -> (
          match range c with
          | Some ((low, high) as r) ->
            let text =
              if Rat.equal low high then Rat.to_string low
              else Printf.sprintf "%s to %s" (Rat.to_string low) (Rat.to_string high)
            in
            { said = text; amount = Amount (middle r) }
          | None -> { said = c.verdict; amount = Named c.verdict }))

let asks_number outcomes name =
  Array.exists (fun o -> Option.is_some (Option.bind (found name o) range)) outcomes

(* Of what there is to be said but a number. *)
let named =
  [
    ("holds", "#228833"); ("holds-up-to-bound", "#99cc88"); ("violated", "#ee6677"); ("undecided", "#ddbb44");
    ("measured", "#8899aa");
  ]

let text r = match Decimal.exact r with Some t -> t | None -> Rat.to_string r
let labels (a : Grid.axis) = Array.map text a.values

(* The parameter that is named first is across, as where [scc check] draws regions: it changes last in the grid. *)
let map ~rows ~columns outcomes name : Chart.map =
  let high = Array.length rows in
  let row j = Array.init (Array.length columns) (fun i -> cell name outcomes.((i * high) + j)) in
  { title = name; rows; columns; cells = Array.init high row }

let chart ~title grid outcomes =
  let names = names outcomes in
  let caption = Printf.sprintf "%d points" (Array.length outcomes) in
  match several grid with
  | [ x ] ->
    let curves, others = List.partition (asks_number outcomes) names in
    let map = map ~rows:[| "" |] ~columns:(labels x) outcomes in
    Chart.sheet ~title ~caption ~x:x.name ~named (List.map (curve x outcomes) curves) (List.map map others)
  | [ x; y ] ->
    let map = map ~rows:(labels y) ~columns:(labels x) outcomes in
    let caption = Printf.sprintf "%s; upwards %s" caption y.name in
    Chart.sheet ~title ~caption ~x:x.name ~named [] (List.map map names)
  | _ -> Scc_base.Bug.fail __POS__ "no chart over these axes"
