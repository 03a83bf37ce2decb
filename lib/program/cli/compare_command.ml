open Scc_base
open Scc_exact
open Scc_equivalence
open Scc_verdicts
open Cmdliner

type options = {
  relation : Compare.relation;
  first : string;
  second : string;
  overrides : (string * Rat.t) list;
  left : (string * Rat.t) list;
  right : (string * Rat.t) list;
  hidden : Hide.pattern list;
  renamed : (string * string) list;
  write : string option;
  budget : Budget.t;
}

(* Names and labels of the first as the second has them. *)
let renaming o ~first =
  let rules = if first then List.map (fun (from, into) -> Label.rule from into) o.renamed else [] in
  Label.rename rules

(* Without those that are not to be seen, and with the draws of an instant as one. *)
let labelled o ~first g =
  let rename = renaming o ~first in
  let told label =
    let label = rename label in
    if List.exists (fun p -> Hide.matches p label) o.hidden then Graph.tau else label
  in
  Draws.joined ~told g

let exit_code (first : Compared.t) (second : Compared.t) (report : Compare.report) : Exit_code.t =
  let resources c =
    match Exit_code.of_bounds (Compared.stopped_by c) with
    | Stopped -> true
    | Holds | Violated | Undecided | Invalid | Usage | Bug | Unwritten -> false
  in
  match report.verdict with
  | Equivalent -> Holds
  | Different _ -> Violated
  | Undecided Effort_spent -> Stopped
  | Undecided Unknown_states when resources first || resources second -> Stopped
  | Undecided _ -> Undecided

let graph_file prefix n = Printf.sprintf "%s-%d.aut" prefix n

let write_graphs o first second =
  match o.write with
  | None -> Ok ()
  | Some prefix ->
    let file n g = (graph_file prefix n, Aut.write g) in
    Result.listed (Whole_file.write [ file 1 first; file 2 second ])

let compare console o =
  let watch = Check_options.watch o.budget in
  let load ~first path overrides =
    let progress = Progress.show ~about:path console o.budget in
    let options = Check_options.options watch o.budget ~progress in
    Compared.load console options ~renamed:(renaming o ~first) ~overrides:(o.overrides @ overrides) path
  in
  let* first = load ~first:true o.first o.left in
  let* second = load ~first:false o.second o.right in
  let written = ref (Ok ()) in
  let work () =
    let prepared ~first (c : Compared.t) =
      Compare.prepare o.relation (labelled o ~first (Later.force c.graph))
    in
    let one = prepared ~first:true first and two = prepared ~first:false second in
    written := write_graphs o one two;
    let effort = Effort.make ~stop:(fun () -> Option.is_some (Watch.stop watch ())) in
    Ok (Compare.run effort o.relation one two)
  in
  let* report =
    match (Watch.attempt watch).run Concluding work with Ok found -> found | Error _ -> Ok Compare.given_up
  in
  Watch.finish watch;
  let code = Exit_code.worst [ exit_code first second report; Guard.unwritten console [ !written ] ] in
  let told = { Compare_report.relation = o.relation; first; second; report; exit = code } in
  Console.answer console
    ~text:(fun () -> Compare_report.text console told)
    ~json:(fun () -> Compare_json.json console told);
  Ok code

let run color json o =
  let console = Console.make ~color ~json () in
  let graph prefix n = Outputs.file "a file of --write" (Some (graph_file prefix n)) in
  let outputs = Option.fold ~none:[] ~some:(fun prefix -> graph prefix 1 @ graph prefix 2) o.write in
  Guard.run_on_two ~outputs console o.first o.second (fun () -> compare console o)

(** {2 The command line} *)

let input index docv =
  let doc = Printf.sprintf "The %s model, or a graph in the format $(b,.aut)." docv in
  Arg.(required & pos index (some string) None & info [] ~docv:(String.uppercase_ascii docv) ~doc)

let relation =
  Options.default (Arg.enum Compare_report.relations) Compare.Branching [ "modulo" ] ~docv:"RELATION"
    "The equivalence: $(b,trace), $(b,weak), $(b,branching), $(b,strong) or $(b,timed) (see RELATIONS)."

let definitions names what =
  let doc = Printf.sprintf "As $(b,-D), for the %s model only. Repeatable." what in
  Arg.(value & opt_all Options.override [] & info names ~docv:"NAME=VALUE" ~doc)

let overrides =
  Options.repeated Options.override [ "D"; "define" ] ~docv:"NAME=VALUE"
    "Gives the parameter $(i,NAME) of both models the value $(i,VALUE), a rational. Repeatable."

let renaming =
  let refuse fmt = Printf.ksprintf (fun s -> Error (`Msg s)) fmt in
  let parse s =
    match String.index_opt s '=' with
    | Some i when i > 0 ->
      let from = String.sub s 0 i and into = String.sub s (i + 1) (String.length s - i - 1) in
      if String.equal into "" then refuse "`%s' gives no new name" s
      else if Label.stars into > Label.stars from then refuse "`%s' has more stars after the = than before" s
      else Ok (from, into)
    | _ -> refuse "`%s' is not of the form FROM=TO" s
  in
  Arg.conv ~docv:"FROM=TO" (parse, fun ppf (from, into) -> Format.fprintf ppf "%s=%s" from into)

let renamed =
  Options.repeated renaming [ "rename" ] ~docv:"FROM=TO"
    "Changes the labels of the first model before the comparison. $(i,FROM) is a name of a body, a part or a \
     channel, which is replaced wherever it occurs in a label ($(b,p=left)). If it has a bracket or a $(b,*), it \
     is a pattern for whole labels: the texts that match its stars replace the stars of $(i,TO) ($(b,'bind(a, \
     *\\)=bind(b, *\\)')). The first matching pattern decides; else all names are replaced at once. Repeatable."

let write =
  Options.maybe Options.named [ "write" ] ~docv:"PREFIX"
    "Writes the two graphs as they are compared, renamed, hidden and with the relation's treatment of time, to \
     $(docv)-1.aut and $(docv)-2.aut."

let options =
  let make relation first second overrides left right hidden renamed write budget =
    { relation; first; second; overrides; left; right; hidden; renamed; write; budget }
  in
  Term.(
    const make $ relation $ input 0 "first" $ input 1 "second" $ overrides
    $ definitions [ "left" ] "first" $ definitions [ "right" ] "second"
    $ Hide.patterns ~also:" In both, and after $(b,--rename)." () $ renamed $ write $ Check_options.budget)

let exits =
  Exits.man ()
    ~told:
      [
        (Holds, "if the two are equivalent: a proof.");
        (Violated, "if they are not.");
        (Undecided, "if that is not known.");
        (Invalid, "if a model or a graph is invalid.");
        ( Stopped,
          "if the answer is unknown since a limit of seconds or memory, or an interruption, ended the work." );
      ]

let command =
  Cmd.v
    (Cmd.info "compare" ~doc:"decide whether two models are equivalent, and why not" ~man:Manual.compare
       ~exits)
    Term.(const run $ Options.color $ Options.json $ options)
