open Scc_base
open Scc_property
open Scc_loading
open Scc_verify
open Scc_verdicts
open Scc_lsp

let budget = { Budget.depth = None; time = None; states = None; seconds = None; memory = None; bits = None }

let viewed ~read_file source checks : Viewed.options =
  {
    path = Source.name source;
    source = Some source;
    read_file = Some read_file;
    given = { values = []; narrowed = [] };
    budget;
    checks;
    schedule = None;
    graph = 1000;
    plots = [];
  }

(* `safe` stands for all checks of the loop that declares it, such as `safe[2]`. *)
let named name (checks : Property.check list) =
  let is_it (c : Property.check) =
    String.equal c.name name
    || match String.index_opt c.name '[' with Some i -> String.equal (String.sub c.name 0 i) name | None -> false
  in
  match List.filter is_it checks with
  | _ :: _ as found -> Ok found
  | [] -> Error [ Input.no_check Code.unknown_name Span.command_line name checks ]

let verdict console (l : Loaded.t) where (o : Verdict.outcome) : Session.verdict =
  let where = List.assoc_opt o.check.name where in
  {
    name = o.check.name;
    kind = Scc_reports.Check_json.kind o.verdict;
    text = Verdict.outcome_to_string o;
    run = Check_text.property console ~full:false ?where l.semantics ~from:l.declared o;
    shown = Option.is_some (Verdict.shown o.verdict);
  }

let decide ~read_file ~progress ~check source =
  let progress ~phase:_ = progress in
  let console = Console.make ~progress ~color:Never ~json:true () in
  let options = viewed ~read_file source All in
  let* l = Viewed.model console options None in
  let* checks = match check with None -> Ok l.checks | Some name -> named name l.checks in
  let watch = Check_options.watch ~signals:false budget in
  let* outcomes, (where, _) = Viewed.report console options l checks watch in
  Watch.dismiss watch;
  Ok (List.map (verdict console l where) outcomes)

let page ~read_file ~progress ~check source path =
  let progress ~phase:_ = progress in
  let console = Console.make ~progress ~color:Never ~json:true () in
  let checks : Viewed.checks = match check with None -> All | Some name -> Only name in
  let watch = Check_options.watch ~signals:false budget in
  let* document = Viewed.document console (viewed ~read_file source checks) watch in
  Watch.dismiss watch;
  let title = document.name ^ " – scc" in
  let write put = Scc_view.Page.write ~title (Scc_view.Document.write document) put in
  Result.listed (Whole_file.with_file path write)

let work = { Commands.decide; page }
