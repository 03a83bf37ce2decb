open Scc_base
open Scc_exact
open Scc_json
open Recorded

(* What is read of a line; [inexact] tells that a number in it was written as a float. *)
type context = { at : Span.t; line : int; inexact : bool ref }

let wrong c fmt = Printf.ksprintf (fun m -> Error (malformed c.at "%s" m)) fmt

let all c what read items =
  match items with `List l -> Result.all (read c) l | _ -> wrong c "`%s` is not an array" what

let rational c what json =
  match number json with
  | Some (q, is_float) ->
    if is_float then c.inexact := true;
    Ok q
  | None -> wrong c "`%s` is no number" what

let optional json key read =
  match Json.member key json with
  | None -> Ok None
  | Some v -> Result.map Option.some (read v)

let required c json key read =
  match Json.member key json with None -> wrong c "there is no `%s`" key | Some v -> read v

let text c what = function `String s -> Ok s | _ -> wrong c "`%s` is not a text" what
let texts c what json = all c what (fun c j -> text c what j) json

(* {1 Labels} *)

let vector c what json =
  let* numbers = all c what (fun c j -> rational c what j) json in
  match numbers with
  | [ x; y; z ] -> Ok (Vec.make x y z)
  | _ -> wrong c "`%s` has three coordinates" what

let bond_ends c json =
  let* ends = texts c "ends" json in
  if List.length ends = 2 then Ok ends else wrong c "`ends` are two"

let bond c json =
  let* name = optional json "name" (text c "name") in
  let* ends = optional json "ends" (bond_ends c) in
  Ok (Option.to_list name, Option.value ends ~default:[])

(* An event of these bodies of which nothing else is known. *)
let plain kind bodies =
  { kind; channels = []; bodies; features = []; together = []; velocity = None; spin = None }

(* Either names of leaves in `between` or `bodies`, or the ends of bonds. *)
let label c json =
  let* kind = required c json "kind" (text c "kind") in
  let* between = optional json "between" (texts c "between") in
  let* listed = optional json "bodies" (texts c "bodies") in
  let bodies = Option.value between ~default:[] @ Option.value listed ~default:[] in
  match (kind, kind_of_name kind) with
  | ("time" | "lot"), _ -> Ok None
  | _, None -> wrong c "`%s` is none of time, bind, close, bounce, absorb, weak, strong, draw and lot" kind
  | _, Some Bounce ->
    if List.length bodies >= 2 then
      Ok (Some (plain Bounce bodies))
    else wrong c "a bounce is of two bodies or more, `between`"
  | _, Some Absorb ->
    if List.length bodies = 2 then
      Ok (Some (plain Absorb bodies))
    else wrong c "an absorption is of two bodies, `between`: who is gone and who took it"
  | _, Some Draw ->
    let* process = required c json "process" (text c "process") in
    let* velocity = optional json "velocity" (vector c "velocity") in
    let* spin = optional json "spin" (vector c "spin") in
    Ok (Some { (plain Draw [ process ]) with velocity; spin })
  | _, Some kind ->
    let* own = bond c json in
    let* more = match Json.member "bonds" json with None -> Ok [] | Some l -> all c "bonds" bond l in
    let bonds = own :: more in
    let channels = List.sort_uniq String.compare (List.concat_map fst bonds) in
    let features = sort (List.map normal (List.concat_map snd bonds)) in
    let told = function
      | _, [] -> None
      | names, ends -> Some (bond_text (String.concat "" names) (List.map normal ends))
    in
    let together = sort (List.filter_map told bonds) in
    if bodies = [] && features = [] then wrong c "neither `ends` nor `bodies` tell what takes part"
    else Ok (Some { (plain kind bodies) with channels; features; together })

(* {1 States} *)

let axes c what quantity json =
  let* v = vector c what json in
  Ok [ (quantity 0, v.x); (quantity 1, v.y); (quantity 2, v.z) ]

let quaternion c json =
  let* numbers = all c "turned" (fun c j -> rational c "turned" j) json in
  match numbers with
  | [ w; x; y; z ] when List.exists (fun q -> Rat.sign q <> 0) numbers -> Ok (w, Vec.make x y z)
  | _ -> wrong c "`turned` is a quaternion that is not 0"

(* [Some None] where null is written. *)
let nullable json (key : string) read =
  match json with
  | `Assoc members -> (
      match List.assoc_opt key members with
      | None -> Ok None
      | Some `Null -> Ok (Some None)
      | Some v -> Result.map (fun x -> Some (Some x)) (read v))
  | _ -> Ok None

let unknown name =
  {
    name; gone = false; numbers = []; turned = None; clock = None; behaviour = None; origin = None; group = None;
    bonds = None;
  }

let leaf c json =
  let* name = required c json "name" (text c "name") in
  let* position = optional json "position" (axes c "position" (fun i -> Position i)) in
  let* turned = optional json "turned" (quaternion c) in
  let* behaviour = optional json "behaviour" (text c "behaviour") in
  let* origin = nullable json "origin" (text c "origin") in
  Ok
    {
      (unknown name) with
      numbers = Option.value position ~default:[]; turned; behaviour; origin;
    }

let process c json =
  let* leaves = required c json "leaves" (all c "leaves" leaf) in
  let* velocity = optional json "velocity" (axes c "velocity" (fun i -> Velocity i)) in
  let* spin = optional json "spin" (axes c "spin" (fun i -> Spin i)) in
  let* clock = nullable json "clock" (rational c "clock") in
  let* bonds = optional json "bonds" (all c "bonds" bond) in
  let moving = Option.value velocity ~default:[] @ Option.value spin ~default:[] in
  let group = sort (List.map (fun (b : body) -> b.name) leaves) in
  let named (names, ends) = bond_text (String.concat "" names) (List.map normal ends) in
  let bonds = Option.map (fun l -> sort (List.map named l)) bonds in
  Ok (List.map (fun b -> { b with numbers = b.numbers @ moving; clock; group = Some group; bonds }) leaves)

let step c json =
  let* remaining = required c json "remaining" (rational c "remaining") in
  let* phase = required c json "phase" (text c "phase") in
  Ok { remaining; phase }

let state c json =
  let* processes = required c json "processes" (all c "processes" process) in
  let* gone = optional json "gone" (texts c "gone") in
  let* step = optional json "step" (step c) in
  let missing = List.map (fun name -> { (unknown name) with gone = true }) (Option.value gone ~default:[]) in
  Ok (State (List.append (List.concat processes) missing, step))

(* {1 Lines} *)

let item ?choice c time what = { line = c.line; at = c.at; time; what; choice }

let transition c json =
  let* time = required c json "time" (rational c "time") in
  let* event = required c json "label" (label c) in
  let* after = optional json "state" (state c) in
  let* rules = optional json "rules" (texts c "rules") in
  let number = Option.bind (Json.member "choice" json) Json.int in
  let choice = { number; rules } in
  let first =
    match (event, after) with
    | Some e, _ -> [ Event e ]
    | None, None -> [ State ([], None) ]
    | None, Some _ -> []
  in
  Ok (List.map (item ~choice c time) (first @ Option.to_list after))

let ended c json =
  let* time = required c json "time" (rational c "time") in
  let* ending = optional json "ending" (text c "ending") in
  let* claims =
    match ending with
    | Some "quiescent" -> Ok [ Quiescent ]
    | Some "stuck" -> Ok [ Stuck ]
    | Some ("open" | "zeno" | "interrupted") | None -> Ok []
    | Some e -> wrong c "`%s` is none of open, quiescent, stuck, zeno and interrupted" e
  in
  let items = List.map (item c time) (State ([], None) :: claims) in
  Ok (items, Some { last = List.hd items; claim = ending })

let one_line c json =
  match Json.member "type" json with
  | Some (`String "transition") -> Result.map (fun items -> (items, None)) (transition c json)
  | Some (`String ("state" | "instant")) ->
    let* time = required c json "time" (rational c "time") in
    let* s = required c json "state" (state c) in
    Ok ([ item c time s ], None)
  | Some (`String "end") -> ended c json
  | _ -> wrong c "`type` is none of header, state, transition, instant and end"

type header = {
  digest : (string * Span.t) option;
  parameters : (string * Rat.t) list;
  semantics : string option;
}

let no_header = { digest = None; parameters = []; semantics = None }

let header c json =
  let* digest = optional json "digest" (text c "digest") in
  let* version = optional json "version" (fun v -> Ok (Json.int v)) in
  let* () =
    match version with
    | None | Some (Some (1 | 2)) -> Ok ()
    | Some _ -> wrong c "the version of the format is none of 1 and 2, which this scc reads"
  in
  let semantics = Option.bind (Json.member "semantics" json) Json.string in
  let* parameters =
    match Json.member "parameters" json with
    | None -> Ok []
    | Some (`Assoc members) ->
      let read (name, v) = Result.map (fun q -> (name, q)) (rational { c with inexact = ref false } name v) in
      Result.all read members
    | Some _ -> wrong c "`parameters` is not an object"
  in
  Ok { digest = Option.map (fun d -> (d, c.at)) digest; parameters; semantics }

let is_header json = match Json.member "type" json with Some (`String "header") -> true | _ -> false

(* What is read so far, the latest first. *)
type sofar = { found : item list; ends : ending option; float_at : Span.t option }

let read source =
  let s = Source.text source and file = Source.name source in
  let finish head r =
    {
      name = file; format = "jsonl"; digest = head.digest; parameters = head.parameters;
      semantics = head.semantics;
      items = Array.of_list (List.rev r.found); ending = r.ends;
      inexact = r.float_at;
    }
  in
  let rec lines number start head r =
    if start >= String.length s then Ok (finish head r)
    else
      let stop = Option.value (String.index_from_opt s start '\n') ~default:(String.length s) in
      if String.trim (String.sub s start (stop - start)) = "" then lines (number + 1) (stop + 1) head r
      else
        let c = { at = Span.make ~file ~start ~stop; line = number; inexact = ref false } in
        let* json =
          Result.map_error
            (fun (d : Diag.t) -> malformed c.at "%s" d.message)
            (Json.parse_line source ~start ~stop)
        in
        if is_header json then
          if number > 1 then wrong c "a header that is not the first line"
          else
            let* head = header c json in
            lines (number + 1) (stop + 1) head r
        else
          let* items, ending = one_line c json in
          let ends = if Option.is_some ending then ending else r.ends in
          let float_at = if !(c.inexact) && Option.is_none r.float_at then Some c.at else r.float_at in
          lines (number + 1) (stop + 1) head { found = List.rev_append items r.found; ends; float_at }
  in
  lines 1 (Source.after_mark s) no_header { found = []; ends = None; float_at = None }
  |> Result.listed
