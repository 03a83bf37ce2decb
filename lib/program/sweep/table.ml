open Scc_exact
open Scc_elaborate
open Scc_loading
open Scc_json
open Scc_runs
open Scc_reports
open Json_format

type t = {
  name : string option;
  digest : string;
  grid : Grid.t;
  bounds : (string * string) list;
  checks : string list;
  decimals : int option;
  diffuses : bool;
  estimated : (string * string) list option;
}

let origin (o : Origin.t) = (o.name, o.digest)

(* {1 CSV} *)

let csv_line fields =
  let b = Buffer.create 128 in
  Scc_export.Table.line (Buffer.add_string b) fields;
  Buffer.contents b

let sides = [ "least"; "greatest" ]

let number_columns t =
  let rounded way =
    Option.fold ~none:"" ~some:(fun k -> Printf.sprintf " (rounded%s to %d decimals)" way k) t.decimals
  in
  let ends side = [ side ^ "from" ^ rounded " down"; side ^ "to" ^ rounded " up" ] in
  match t.estimated with
  | None -> List.concat_map (fun side -> ends (side ^ " ")) sides
  | Some _ -> (("estimate" ^ rounded "") :: ends "") @ [ "runs" ]

let csv_header t =
  let after = (if t.diffuses then [ "kick" ] else []) @ [ "check"; "verdict" ] @ number_columns t @ [ "why" ] in
  let parameter (a : Grid.axis) =
    if List.mem a.name ("point" :: after) then Printf.sprintf "(%s)" a.name else a.name
  in
  csv_line (("point" :: List.map parameter t.grid) @ after)

let number_fields t (c : Outcome.check) =
  let text exactly rounded = function
    | None -> ""
    | Some x -> ( match t.decimals with None -> exactly x | Some places -> rounded ~places x)
  in
  let field side =
    match List.find_opt (fun (n : Outcome.number) -> String.equal n.over side) c.numbers with
    | None -> [ ""; "" ]
    | Some { infinite = true; _ } -> [ "infinite"; "infinite" ]
    | Some n ->
      [ text Rat.to_string Decimal.rounded_down n.low; text Rat.to_string Decimal.rounded_up n.high ]
  in
  match c.estimate with
  | None -> List.concat_map field sides
  | Some { never = true; runs; _ } -> [ "infinite"; "infinite"; "infinite"; string_of_int runs ]
  | Some { value; from; upto; runs; _ } ->
    [
      text Rat.to_string Decimal.fixed value;
      text Rat.to_string Decimal.rounded_down from;
      text Rat.to_string Decimal.rounded_up upto;
      string_of_int runs;
    ]

let remarks (c : Outcome.check) =
  match c.estimate with
  | Some { approximate = true; _ } -> [ "the interval is approximate: right if the mean of the runs is normal" ]
  | Some _ | None -> []

let csv t k outcome =
  let start = string_of_int k :: List.map (fun (_, r) -> Rat.to_string r) (Grid.point t.grid k) in
  let start = start @ if t.diffuses then [ Lattices.kicks (Outcome.lattices outcome) ] else [] in
  match (outcome : Outcome.t) with
  | Refused { code; message } ->
    let nothing = List.map (fun _ -> "") (number_columns t) in
    csv_line (start @ [ ""; "invalid" ] @ nothing @ [ Printf.sprintf "%s: %s" code message ])
  | Checked { checks; _ } ->
    let line (c : Outcome.check) =
      csv_line (start @ [ c.name; c.verdict ] @ number_fields t c @ [ String.concat "; " (c.reasons @ remarks c) ])
    in
    String.concat "" (List.map line checks)

(* {1 JSON} *)

let header_format =
  let axis =
    fields
      [
        field "name" text (fun (a : Grid.axis) -> a.name);
        field "values" (array ~least:1 Shared.rational) (fun (a : Grid.axis) -> a.values);
      ]
  in
  fields
    (Shared.head "scc-sweep" 1
     @ [
       Shared.semantics ();
       field "model" (nullable text) (fun t -> t.name);
       field "digest" Shared.digest (fun t -> t.digest);
       field "bounds" (entries text) (fun t -> t.bounds) ~about:"The bounds that were given, by their options.";
       maybe "checks" (list ~least:1 text)
         (fun t -> match t.checks with [] -> None | _ :: _ -> Some t.checks)
         ~about:"The names of the checks that were chosen; without it, all.";
       maybe "estimated" (entries text) (fun t -> t.estimated)
         ~about:"With --estimate: how the runs are made and judged, by the options of `scc estimate`.";
       field "grid" (list ~least:1 axis) (fun t -> t.grid)
         ~about:"The points are all combinations, numbered from 0; the last parameter goes fastest.";
     ])

let check =
  let end_ of_number =
    let infinite (n : Outcome.number) = if n.infinite then Some () else None in
    let finite (n : Outcome.number) = if n.infinite then None else Some (of_number n) in
    union [ case (constant (`String "infinite")) infinite Fun.id; case (nullable Shared.rational) finite ignore ]
    |> named ~file:"sweep" "end"
  in
  let estimate =
    let finite f (e : Outcome.estimate) = f e in
    fields
      [
        field "value" (nullable Shared.rational) (finite (fun e -> e.value))
          ~about:"The share or the mean of the runs. Null if not all of them have one.";
        field "low" (nullable Shared.rational) (finite (fun e -> e.from));
        field "high" (nullable Shared.rational) (finite (fun e -> e.upto));
        field "infinite" bool (finite (fun e -> e.never)) ~about:"True if some run never comes to it.";
        maybe "approximate" (constant (`Bool true))
          (fun (e : Outcome.estimate) -> if e.approximate then Some () else None)
          ~about:"With --normal, if the interval is that of a normal mean, which is not proved.";
        field "runs" natural (finite (fun e -> e.runs));
      ]
  in
  let verdict =
    let of_estimates = [ "estimated"; "sampled"; "estimated_holds"; "estimated_violated"; "undecided" ] in
    let is_estimate v = if List.mem v of_estimates then Some v else None in
    union
      [
        case Check_json.kind_format (fun v -> if is_estimate v = None then Some v else None) Fun.id;
        case (word Fun.id of_estimates) is_estimate Fun.id;
      ]
  in
  let number =
    fields
      [
        field "over" (word Fun.id sides) (fun (n : Outcome.number) -> n.over);
        field "low" (end_ (fun n -> n.low)) Fun.id;
        field "high" (end_ (fun n -> n.high)) Fun.id;
      ]
  in
  fields
    [
      field "name" text (fun (c : Outcome.check) -> c.name);
      field "verdict" verdict (fun (c : Outcome.check) -> c.verdict)
        ~about:"As of `scc check`; of an estimate, as of `scc estimate`.";
      field "values" (list number) (fun (c : Outcome.check) -> c.numbers)
        ~about:"Of a check that asks for a number: where it is, over all schedulers.";
      maybe "estimate" estimate (fun (c : Outcome.check) -> c.estimate) ~about:"With --estimate, of runs.";
      field "reasons" Shared.texts (fun (c : Outcome.check) -> c.reasons)
        ~about:"Why it is not known, or no better; bounds up to which it holds.";
    ]

let lattice =
  let lattice f (l : Lattices.t) = f l.lattice in
  fields
    [
      field "bodies" (list ~least:1 text) (fun (l : Lattices.t) -> l.bodies)
        ~about:"Names of bodies; a family once, by its name.";
      field "kick" Shared.rational (lattice (fun l -> l.kick));
      field "chosen" bool (lattice (fun l -> l.chosen))
        ~about:"The model does not give the kick: it is the least power of two that is long enough.";
      maybe "spin" Shared.rational (lattice (fun l -> l.spin))
        ~about:"The spin of a kick of the orientation, of laws that say `turning`.";
    ]

let point_format =
  let refusal = fields [ field "code" Shared.code fst; field "message" text snd ] in
  let refused : Outcome.t -> _ = function Refused { code; message } -> Some (code, message) | Checked _ -> None in
  let lattices o = match Outcome.lattices o with [] -> None | _ :: _ as lattices -> Some lattices in
  fields
    [
      field "point" natural (fun (_, k, _) -> k);
      field "parameters" Origin_json.parameters_format (fun (t, k, _) -> Grid.point t.grid k);
      field "refused" (nullable refusal) (fun (_, _, o) -> refused o)
        ~about:"Why the model is invalid there; then there are no checks.";
      maybe "lattices" (list ~least:1 lattice) (fun (_, _, o) -> lattices o)
        ~about:"Of the bodies that diffuse: the lengths of their kicks.";
      field "checks" (list check) (fun (_, _, o) -> Outcome.checks o);
    ]

let format =
  union [ case header_format Either.find_left ignore; case point_format Either.find_right ignore ]

let line x = Json.line (write format x) ^ "\n"
let json_header t = line (Left t)
let json t k outcome = line (Right (t, k, outcome))
