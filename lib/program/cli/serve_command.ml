open Scc_base
open Scc_verdicts
open Scc_json
open Scc_serve
open Cmdliner

(* {1 Its own processes}

   They are this program, with the same arguments and one more that says what is to be done. *)

type task = Desk | Document of { checks : Viewed.checks; seconds : float option }

let task_json : task -> Json.t = function
  | Desk -> `String "desk"
  | Document { checks; seconds } ->
    let checks : Json.t =
      match checks with
      | All -> `String "all"
      | Unchecked -> `String "none"
      | Only name -> `Assoc [ ("only", Json.text name) ]
    in
    let whole s = `Int (int_of_float s) in
    `Assoc [ ("check", checks); ("seconds", Json.option whole seconds) ]

let checks_of : Json.t -> (Viewed.checks, string) result = function
  | `String "all" -> Ok All
  | `String "none" -> Ok Unchecked
  | `Assoc [ ("only", `String name) ] -> Ok (Only name)
  | _ -> Error "`check` is \"all\", \"none\" or {\"only\": NAME}"

let task_of text =
  match Yojson.Basic.from_string text with
  | `String "desk" -> Ok Desk
  | `Assoc _ as json ->
    let seconds = Option.map float_of_int (Option.bind (Json.member "seconds" json) Json.int) in
    let* checks = checks_of (Option.value (Json.member "check" json) ~default:`Null) in
    Ok (Document { checks; seconds })
  | _ | (exception Yojson.Json_error _) -> Error "it is no task"

let arguments task =
  match Array.to_list Sys.argv with
  | program :: command :: rest ->
    Array.of_list (program :: command :: ("--task=" ^ Json.line (task_json task)) :: rest)
  | [ _ ] | [] -> Bug.fail __POS__ "a command without its name"

(* {1 Serving} *)

type options = {
  model : string option;
  given : Options.definitions;
  port : int option;
  task : task option;
}

let unsaved_name = "model.sc"

(* What one sees who begins without a model. *)
let start =
  {|// Two cubes fly towards each other and stick together.
model meeting

timestep 1/2

shape Cube {
  vertices a (-1, -1, -1)  b (1, -1, -1)  c (1, 1, -1)  d (-1, 1, -1)  e (-1, -1, 1)  f (1, -1, 1)
           g (1, 1, 1)  h (-1, 1, 1)
  faces    back [a, d, c, b]  front [e, f, g, h]  left [a, e, h, d]  right [b, c, g, f]
           bottom [a, b, f, e]  top [d, h, g, c]
}

process p = Cube mass 1 velocity (1, 0, 0) at translate (-4, 0, 0) [<a, {right}>. nil]
process q = Cube mass 2 velocity (-1/2, 0, 0) at translate (4, 0, 0) [<~a, {left}>. nil]

check meet : eventually bound(p, q) within 5
|}

let served_graph = 400

let viewed o budget checks =
  {
    Viewed.path = Option.value o.model ~default:unsaved_name;
    source = None;
    read_file = None;
    given = o.given;
    budget;
    checks;
    schedule = None;
    graph = served_graph;
    plots = [];
  }

let bound (b : Scc_calculus.Ranges.bound) : Json.t =
  `Assoc [ ("value", Json.rat b.value); ("included", `Bool b.included) ]

let parameters (given : Options.definitions) =
  let value (name, v) = (name, Json.rat v) in
  let range (name, (low, high)) = (name, `Assoc [ ("low", bound low); ("high", bound high) ]) in
  List.map value given.values @ List.map range given.narrowed

let desk console o =
  let told result = Result.map_error (fun (d : Diag.t) -> d.message) result in
  let read path = told (Result.map Source.text (Input.read console path)) in
  let write path text = told (Whole_file.with_file path (fun put -> put text)) in
  let name = Filename.basename (Option.value o.model ~default:unsaved_name) in
  { Desk.name; path = o.model; read; write; parameters = parameters o.given; start }

let listening console desk address =
  Console.print console (Printf.sprintf "scc: %s is served at %s\n" desk.Desk.name address);
  Console.print console "Open this address in a browser: it works on this machine only. Ctrl-C ends it.\n";
  Console.flush console

let cannot_listen console port why =
  let what =
    match port with
    | Some n -> Printf.sprintf "port %d: %s (without --port, one that is free is taken)" n why
    | None -> Printf.sprintf "any port: %s" why
  in
  Console.note console ("scc: cannot listen on " ^ what);
  Exit_code.Unwritten

let serve console o =
  let desk = desk console o in
  let document_process ~check ~seconds =
    Result.map (fun checks -> arguments (Document { checks; seconds })) (checks_of check)
  in
  let how =
    {
      Server.desk;
      port = o.port;
      desk_process = arguments Desk;
      document_process;
      listening = listening console desk;
    }
  in
  match Server.run how with
  | Ok () -> Exit_code.Holds
  | Error why -> cannot_listen console o.port why

let run color (budget : Budget.t) o =
  match (o.task, o.model) with
  | Some Desk, _ -> Document_process.desk ~path:(Option.value o.model ~default:unsaved_name)
  | Some (Document { checks; seconds }), _ ->
    let seconds = match seconds with None -> budget.seconds | Some _ -> seconds in
    Document_process.document (viewed o { budget with seconds } checks)
  | None, Some "-" -> Guard.usage "standard input cannot be served: the model is a file"
  | None, _ ->
    let console = Console.make ~color ~json:false () in
    Guard.run console (fun () ->
        let* () = Input.check_overrides (List.map fst o.given.values @ List.map fst o.given.narrowed) in
        Ok (serve console o))

(* {1 The command line} *)

let model =
  let doc =
    "The model, a $(b,.sc) file, which need not exist yet. Without a file, the page begins with a small model \
     and saves nothing."
  in
  Arg.(value & pos 0 (some string) None & info [] ~docv:"MODEL" ~doc)

let port =
  let doc = "Listens on this port of the machine's own address 127.0.0.1, instead of a free one." in
  let number = Options.integer ~least:1 ~most:65535 "port, a number from 1 to 65535" in
  Arg.(value & opt (some number) None & info [ "port" ] ~docv:"PORT" ~doc)

let task =
  let parse text = Result.map_error (fun why -> `Msg why) (task_of text) in
  let task = Arg.conv (parse, fun ppf t -> Format.pp_print_string ppf (Json.line (task_json t))) in
  Arg.(value & opt (some task) None & info [ "task" ] ~docs:Manpage.s_none)

let options =
  let make model given port task = { model; given; port; task } in
  Term.(const make $ model $ Options.definitions $ port $ task)

let command =
  let told =
    [
      (Exit_code.Holds, "if Ctrl-C, or another interruption, has ended the service.");
      (Stopped, "if nobody reads the address that it prints.");
      (Unwritten, "if it cannot listen on the port, or the address could not be printed.");
    ]
  in
  let exits = Exits.man ~told ~never:[ Violated; Undecided; Invalid ] () in
  Cmd.v
    (Cmd.info "serve" ~doc:"write and look at a model in a browser" ~man:Manual.serve ~exits)
    Term.(const run $ Options.color $ Check_options.budget $ options)
