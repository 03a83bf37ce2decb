open Scc_base
open Recorded

let columns =
  [
    "time"; "event"; "bodies"; "channel"; "features"; "x"; "y"; "z"; "vx"; "vy"; "vz"; "wx"; "wy"; "wz";
    "behaviour";
  ]

(* {1 Rows and cells} *)

(* A cell may be quoted, with a quote in it written twice; it ends with its line. *)
let cells text =
  let n = String.length text in
  let b = Buffer.create 64 in
  let cell () =
    let c = String.trim (Buffer.contents b) in
    Buffer.clear b;
    c
  in
  let rec plain i acc =
    if i >= n then Some (List.rev (cell () :: acc))
    else
      match text.[i] with
      | ',' -> plain (i + 1) (cell () :: acc)
      | '"' when String.trim (Buffer.contents b) = "" ->
        Buffer.clear b;
        quoted (i + 1) acc
      | c ->
        Buffer.add_char b c;
        plain (i + 1) acc
  and quoted i acc =
    if i >= n then None
    else if text.[i] <> '"' then begin
      Buffer.add_char b text.[i];
      quoted (i + 1) acc
    end
    else if i + 1 < n && text.[i + 1] = '"' then begin
      Buffer.add_char b '"';
      quoted (i + 2) acc
    end
    else plain (i + 1) acc
  in
  plain 0 []

let words ~spaces text =
  let text = if spaces then String.map (fun c -> if c = ' ' || c = '\t' then ';' else c) text else text in
  String.split_on_char ';' text |> List.map String.trim |> List.filter (fun w -> w <> "")

type row = { line : int; at : Span.t; get : string -> string }

(* {1 Rows as items} *)

let number row column =
  match literal (row.get column) with
  | Some n -> Ok n
  | None -> Error (malformed row.at "`%s` is no number: `%s`" column (row.get column))

let untold row allowed =
  match List.find_opt (fun c -> row.get c <> "" && not (List.mem c allowed)) columns with
  | None -> Ok ()
  | Some c -> Error (malformed row.at "a row `%s` has nothing in the column `%s`" (row.get "event") c)

(* All three, or none. *)
let drawn row (x, y, z) =
  if not (List.exists (fun c -> row.get c <> "") [ x; y; z ]) then Ok (None, false)
  else
    let* x, x_float = number row x in
    let* y, y_float = number row y in
    let* z, z_float = number row z in
    Ok (Some (Scc_exact.Vec.make x y z), x_float || y_float || z_float)

let event row kind =
  let of_bonds = match kind with Bounce | Absorb | Draw -> false | Bind | Close | Weak | Strong -> true in
  let motion = [ "vx"; "vy"; "vz"; "wx"; "wy"; "wz" ] in
  let of_kind = if of_bonds then [ "channel"; "features" ] else if kind = Draw then motion else [] in
  let allowed = [ "time"; "event"; "bodies" ] @ of_kind in
  let* () = untold row allowed in
  let bodies = words ~spaces:true (row.get "bodies") in
  let features = sort (List.map normal (words ~spaces:false (row.get "features"))) in
  let channels = List.sort_uniq String.compare (words ~spaces:true (row.get "channel")) in
  let count = List.length bodies in
  let* () =
    match kind with
    | Absorb when count <> 2 ->
      Error (malformed row.at "a row `absorb` is of two bodies, who is gone and who took it, not of %d" count)
    | Bounce when count < 2 -> Error (malformed row.at "a bounce is of two bodies or more, not of %d" count)
    | (Bind | Close | Weak) when count <> 2 && not (count = 0 && features <> []) ->
      Error (malformed row.at "a row `%s` is of two bodies, not of %d" (kind_name kind) count)
    | Strong when count = 0 && features = [] -> Error (malformed row.at "a row `strong` names no bodies")
    | Draw when count <> 1 -> Error (malformed row.at "a row `draw` is of one body, not of %d" count)
    | Bounce | Absorb | Bind | Close | Weak | Strong | Draw -> Ok ()
  in
  let* velocity, one = drawn row ("vx", "vy", "vz") in
  let* spin, other = drawn row ("wx", "wy", "wz") in
  Ok (Event { kind; channels; bodies; features; together = []; velocity; spin }, one || other)

let state row =
  let* () = untold row [ "time"; "event"; "bodies"; "x"; "y"; "z"; "vx"; "vy"; "vz"; "behaviour" ] in
  match words ~spaces:true (row.get "bodies") with
  | [ name ] ->
    let read acc (column, quantity) =
      let* numbers, inexact = acc in
      if row.get column = "" then Ok (numbers, inexact)
      else
        let* q, is_float = number row column in
        Ok ((quantity, q) :: numbers, inexact || is_float)
    in
    let all = [ Position 0; Position 1; Position 2; Velocity 0; Velocity 1; Velocity 2 ] in
    let* numbers, inexact =
      List.fold_left read (Ok ([], false)) (List.map (fun q -> (quantity_text q, q)) all)
    in
    let behaviour = match row.get "behaviour" with "" -> None | b -> Some b in
    let body =
      {
        name; gone = false; numbers = List.rev numbers; turned = None; clock = None; behaviour; origin = None;
        group = None; bonds = None;
      }
    in
    Ok (State ([ body ], None), inexact)
  | bodies -> Error (malformed row.at "a row `state` is of one body, not of %d" (List.length bodies))

let bare row what =
  let* () = untold row [ "time"; "event" ] in
  Ok (what, false)

let item row =
  let* time, time_float = number row "time" in
  let* what, inexact =
    match row.get "event" with
    | "state" -> state row
    | "time" -> bare row (State ([], None))
    | "end" -> bare row Watched
    | "quiescent" -> bare row Quiescent
    | "stuck" -> bare row Stuck
    | name -> (
        match kind_of_name name with
        | Some kind -> event row kind
        | None ->
          Error
            (malformed row.at
               "`%s` is none of bind, close, bounce, absorb, weak, strong, draw, state, time, end, quiescent and \
                stuck"
               name))
  in
  Ok ({ line = row.line; at = row.at; time; what; choice = None }, time_float || inexact)

(* {1 The file} *)

let heading at names =
  let unknown = List.find_opt (fun c -> not (List.mem c columns)) names in
  let twice = List.find_opt (fun c -> List.length (List.filter (String.equal c) names) > 1) names in
  match (unknown, twice) with
  | Some c, _ ->
    Error (Diag.error Code.bad_trace at ?hint:(Diag.suggest c columns) "there is no column `%s`" c)
  | None, Some c -> Error (malformed at "the column `%s` stands twice" c)
  | None, None ->
    if List.mem "time" names && List.mem "event" names then Ok ()
    else Error (malformed at "the first row names the columns, `time` and `event` among them")

let lines source =
  let text = Source.text source and file = Source.name source in
  let rec from number start acc =
    if start >= String.length text then List.rev acc
    else
      let stop = Option.value (String.index_from_opt text start '\n') ~default:(String.length text) in
      let line = String.sub text start (stop - start) in
      let at = Span.make ~file ~start ~stop:(max (start + 1) stop) in
      let told = String.trim line in
      let acc = if told = "" || told.[0] = '#' then acc else (number, at, line) :: acc in
      from (number + 1) (stop + 1) acc
  in
  from 1 (Source.after_mark text) []

let row names (line, at, text) =
  match cells text with
  | None -> Error (malformed at "a quote is not closed")
  | Some values when List.length values > List.length names -> Error (malformed at "more cells than columns")
  | Some values ->
    let rec find names values column =
      match (names, values) with
      | n :: _, v :: _ when String.equal n column -> v
      | _ :: names, _ :: values -> find names values column
      | _, _ -> ""
    in
    Ok { line; at; get = find names values }

let most_faults = 20

let read source =
  let empty = Span.make ~file:(Source.name source) ~start:0 ~stop:1 in
  match lines source with
  | [] -> Error [ malformed empty "the trace is empty" ]
  | (_, at, first) :: rest ->
    let names = Option.map (List.map String.lowercase_ascii) (cells first) in
    let* names = Option.to_result ~none:[ malformed at "a quote is not closed" ] names in
    let* () = Result.listed (heading at names) in
    let add (items, inexact, faults) line =
      match Result.bind (row names line) item with
      | Ok (i, is_float) ->
        let inexact = if is_float && Option.is_none inexact then Some i.at else inexact in
        (i :: items, inexact, faults)
      | Error d -> (items, inexact, d :: faults)
    in
    let items, inexact, faults = List.fold_left add ([], None, []) rest in
    if faults <> [] then Error (List.filteri (fun i _ -> i < most_faults) (List.rev faults))
    else
      let end_of found (i : item) =
        let claim = Option.bind found (fun e -> e.claim) in
        match i.what with
        | Watched -> Some { last = i; claim }
        | Quiescent -> Some { last = i; claim = Some "quiescent" }
        | Stuck -> Some { last = i; claim = Some "stuck" }
        | Event _ | State _ -> found
      in
      let items = List.rev items in
      Ok
        {
          name = Source.name source; format = "csv"; digest = None; parameters = []; semantics = None;
          items = Array.of_list items; ending = List.fold_left end_of None items; inexact;
        }
