"""`scc lsp` by the clients of pytest-lsp and pygls, which nobody here wrote: each request as an editor makes it."""

import asyncio
import os
import pathlib

import pytest
import pytest_lsp
from lsprotocol import types as T
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

SCC = os.environ["SCC"]
MODELS = pathlib.Path(__file__).parents[2] / "specs" / "models"

MAIN = """// é 𝄞
import "parts.sc" (Tile)
param n = 2
let far = 3 * n
behaviour Ready on Tile = <dock, {left, right}>. Docked
behaviour Docked on Tile = nil
process p = Tile mass 1 velocity (1, 0, 0) [Ready]
process q = Tile mass 1 at translate (far, 0, 0) [<~dock, {left}>. Docked]
check meets : eventually bound(p, q) within 10
check apart : always x(p) < 0
"""
PARTS = "shape Tile {\n  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)\n           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)\n  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]\n           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]\n}\n"


@pytest_lsp.fixture(
    params=["visual_studio_code", "neovim"],
    config=ClientServerConfig(server_command=[SCC, "lsp"]),
)
async def client(request, lsp_client: LanguageClient, tmp_path):
    for method in [T.WORKSPACE_INLAY_HINT_REFRESH, T.WORKSPACE_CODE_LENS_REFRESH, T.CLIENT_REGISTER_CAPABILITY]:
        lsp_client.feature(method)(lambda *_: None)
    (tmp_path / "parts.sc").write_text(PARTS)
    (tmp_path / "main.sc").write_text(MAIN)
    root = tmp_path.as_uri()
    able = client_capabilities(request.param)
    argument = able.text_document.signature_help.signature_information.parameter_information
    lsp_client.takes_places = bool(argument and argument.label_offset_support)
    await lsp_client.initialize_session(
        T.InitializeParams(capabilities=able, root_uri=root, workspace_folders=[T.WorkspaceFolder(root, "models")])
    )
    lsp_client.uri = (tmp_path / "main.sc").as_uri()
    lsp_client.text = MAIN
    opened(lsp_client, lsp_client.uri, MAIN)
    yield
    await lsp_client.shutdown_session()


def opened(client, uri, text):
    client.text_document_did_open(T.DidOpenTextDocumentParams(T.TextDocumentItem(uri, "scc", 1, text)))


def place(text, piece, inside=0):
    """Where a piece of the text begins, in units of UTF-16."""
    at = text.index(piece) + inside
    line = text.count("\n", 0, at)
    return T.Position(line, len(text[text.rfind("\n", 0, at) + 1 : at].encode("utf-16-le")) // 2)


def at(client, piece, inside=0):
    return {"text_document": T.TextDocumentIdentifier(client.uri), "position": place(client.text, piece, inside)}


def covered(text, span):
    lines = text.split("\n")
    line = lines[span.start.line].encode("utf-16-le")
    return line[2 * span.start.character : 2 * span.end.character].decode("utf-16-le")


async def diagnostics(client, uri, wanted):
    """Waits until the diagnostics of a document are wanted."""
    while not (uri in client.diagnostics and wanted(client.diagnostics[uri])):
        await asyncio.sleep(0.02)
    return client.diagnostics[uri]


async def clean(client):
    return await diagnostics(client, client.uri, lambda found: all(d.code != "SC0101" for d in found))


@pytest.mark.asyncio
async def test_diagnostics(client: LanguageClient):
    assert await clean(client) == ()
    change = T.TextDocumentContentChangePartial(T.Range(place(MAIN, "Ready]"), place(MAIN, "Ready]", 5)), "Raedy")
    client.text_document_did_change(T.DidChangeTextDocumentParams(T.VersionedTextDocumentIdentifier(2, client.uri), [change]))
    found = await diagnostics(client, client.uri, lambda found: len(found) > 0)
    wrong = [d for d in found if d.code == "SC0201"]
    text = MAIN.replace("Ready]", "Raedy]")
    assert [covered(text, d.range) for d in wrong] == ["Raedy"] and "Ready" in wrong[0].message
    actions = await client.text_document_code_action_async(
        T.CodeActionParams(T.TextDocumentIdentifier(client.uri), wrong[0].range, T.CodeActionContext(wrong))
    )
    edit = actions[0].edit
    edits = [e for change in edit.document_changes for e in change.edits] if edit.document_changes else edit.changes[client.uri]
    assert [(covered(text, e.range), e.new_text) for e in edits] == [("Raedy", "Ready")]


@pytest.mark.asyncio
async def test_a_changed_import_changes_its_users(client: LanguageClient):
    await clean(client)
    parts = client.uri.replace("main.sc", "parts.sc")
    opened(client, parts, PARTS.replace("left [", "port ["))
    found = await diagnostics(client, client.uri, lambda found: any(d.code == "SC0301" or d.code == "SC0203" for d in found))
    assert {covered(MAIN, d.range) for d in found} >= {"left"}
    client.text_document_did_close(T.DidCloseTextDocumentParams(T.TextDocumentIdentifier(parts)))
    await diagnostics(client, client.uri, lambda found: found == ())


@pytest.mark.asyncio
async def test_hover_and_values(client: LanguageClient):
    await clean(client)
    shown = await client.text_document_hover_async(T.HoverParams(**at(client, "far, 0")))
    assert "value" in shown.contents.value and "= 6" in shown.contents.value and covered(MAIN, shown.range) == "far"
    shown = await client.text_document_hover_async(T.HoverParams(**at(client, "eventually")))
    assert "language.md" in shown.contents.value
    whole = T.Range(T.Position(0, 0), T.Position(99, 0))
    hints = await client.text_document_inlay_hint_async(T.InlayHintParams(T.TextDocumentIdentifier(client.uri), whole))
    assert [(h.position, h.label) for h in hints] == [(place(MAIN, "far =", 3), "= 6")]


@pytest.mark.asyncio
async def test_definition_and_references(client: LanguageClient):
    found = await client.text_document_definition_async(T.DefinitionParams(**at(client, "Tile mass")))
    assert [(f.uri.rsplit("/", 1)[1], covered(PARTS, f.range)) for f in found] == [("parts.sc", "Tile")]
    found = await client.text_document_definition_async(T.DefinitionParams(**at(client, "Ready]")))
    assert [(f.uri, f.range.start) for f in found] == [(client.uri, place(MAIN, "Ready on"))]
    found = await client.text_document_references_async(T.ReferenceParams(**at(client, "Tile mass"), context=T.ReferenceContext(True)))
    assert sorted(f.uri.rsplit("/", 1)[1] for f in found) == ["main.sc"] * 5 + ["parts.sc"]
    found = await client.text_document_references_async(T.ReferenceParams(**at(client, "dock"), context=T.ReferenceContext(True)))
    assert [covered(MAIN, f.range) for f in found] == ["dock", "dock"]
    found = await client.text_document_document_highlight_async(T.DocumentHighlightParams(**at(client, "Docked on")))
    assert [covered(MAIN, f.range) for f in found] == ["Docked"] * 3


@pytest.mark.asyncio
async def test_rename(client: LanguageClient, tmp_path):
    await clean(client)
    span = await client.text_document_prepare_rename_async(T.PrepareRenameParams(**at(client, "Tile mass")))
    assert covered(MAIN, span.range) == "Tile"
    edit = await client.text_document_rename_async(T.RenameParams(**at(client, "Tile mass"), new_name="Brick"))
    if edit.document_changes:
        changes = {c.text_document.uri: c.edits for c in edit.document_changes}
    else:
        changes = edit.changes
    assert {uri.rsplit("/", 1)[1]: len(edits) for uri, edits in changes.items()} == {"main.sc": 5, "parts.sc": 1}
    for name in ["process", "Ready", "two words", ""]:
        with pytest.raises(Exception, match="name"):
            await client.text_document_rename_async(T.RenameParams(**at(client, "Tile mass"), new_name=name))
    with pytest.raises(Exception):
        await client.text_document_prepare_rename_async(T.PrepareRenameParams(**at(client, "eventually")))


@pytest.mark.asyncio
async def test_completion_and_calls(client: LanguageClient):
    def labels(found):
        return [item.label for item in found.items]

    found = await client.text_document_completion_async(T.CompletionParams(**at(client, "left, right")))
    assert "left" in labels(found) and "top" in labels(found) and "dock" not in labels(found)
    found = await client.text_document_completion_async(T.CompletionParams(**at(client, "dock, {left, right")))
    assert labels(found) == ["dock"]
    found = await client.text_document_completion_async(T.CompletionParams(**at(client, "parts.sc\"")))
    assert "parts.sc" in labels(found)
    found = await client.text_document_completion_async(T.CompletionParams(**at(client, "process p")))
    assert "process" in labels(found) and any("SHAPE" in (item.detail or "") for item in found.items)
    found = await client.text_document_signature_help_async(T.SignatureHelpParams(**at(client, "bound(p, q", 9)))
    assert found.signatures[0].label == "bound(body, body)" and found.active_parameter == 1
    # Of two arguments with one name, editors that can be told mark the one that is meant.
    named = [p.label for p in found.signatures[0].parameters]
    assert named in (["body", "body"], [(6, 10), (12, 16)])
    assert (named != ["body", "body"]) == client.takes_places


@pytest.mark.asyncio
async def test_the_whole_document(client: LanguageClient):
    document = T.TextDocumentIdentifier(client.uri)
    symbols = await client.text_document_document_symbol_async(T.DocumentSymbolParams(document))
    assert [s.name for s in symbols] == ["parts.sc", "n", "far", "Ready", "Docked", "p", "q", "meets", "apart"]
    opened(client, client.uri.replace("main", "parts"), PARTS)
    parts = T.TextDocumentIdentifier(client.uri.replace("main", "parts"))
    folds = await client.text_document_folding_range_async(T.FoldingRangeParams(parts))
    assert (folds[0].start_line, folds[0].end_line) == (0, 5)
    edits = await client.text_document_formatting_async(T.DocumentFormattingParams(parts, T.FormattingOptions(2, True)))
    assert len(edits) == 1 and "(-1, -1, -1)" in edits[0].new_text
    data = (await client.text_document_semantic_tokens_full_async(T.SemanticTokensParams(document))).data
    lines = [line.encode("utf-16-le") for line in MAIN.split("\n")]
    line = character = 0
    words = []
    for k in range(0, len(data), 5):
        character = data[k + 1] + (character if data[k] == 0 else 0)
        line += data[k]
        words.append(lines[line][2 * character : 2 * (character + data[k + 2])].decode("utf-16-le"))
    assert words[:6] == ["// é 𝄞", "import", '"parts.sc"', "Tile", "param", "n"]


@pytest.mark.asyncio
async def test_what_has_changed(client: LanguageClient):
    document = T.TextDocumentIdentifier(client.uri)
    full = await client.text_document_semantic_tokens_full_async(T.SemanticTokensParams(document))
    change = T.TextDocumentContentChangePartial(T.Range(place(MAIN, "3 * n"), place(MAIN, "3 * n", 5)), "n + 33 + 4")
    client.text_document_did_change(T.DidChangeTextDocumentParams(T.VersionedTextDocumentIdentifier(2, client.uri), [change]))
    delta = await client.text_document_semantic_tokens_full_delta_async(T.SemanticTokensDeltaParams(document, full.result_id))
    assert isinstance(delta, T.SemanticTokensDelta) and len(delta.edits) == 1 and len(delta.edits[0].data) < 40
    data = list(full.data)
    edit = delta.edits[0]
    data[edit.start : edit.start + edit.delete_count] = edit.data
    after = await client.text_document_semantic_tokens_full_async(T.SemanticTokensParams(document))
    assert list(after.data) == data
    old = await client.text_document_semantic_tokens_full_delta_async(T.SemanticTokensDeltaParams(document, "none"))
    assert isinstance(old, T.SemanticTokens) and list(old.data) == data
    span = T.Range(place(MAIN, "param n"), place(MAIN, "let far"))
    some = await client.text_document_semantic_tokens_range_async(T.SemanticTokensRangeParams(document, span))
    assert len(some.data) == 15 and some.data[0] == 2


@pytest.mark.asyncio
async def test_layout_of_a_range(client: LanguageClient):
    text = "let  a=1\nlet  b=2\nlet  c=3\n"
    uri = client.uri.replace("main", "new")
    opened(client, uri, text)
    params = T.DocumentRangeFormattingParams(T.TextDocumentIdentifier(uri), T.Range(place(text, "b"), place(text, "b", 1)), T.FormattingOptions(2, True))
    edits = await client.text_document_range_formatting_async(params)
    assert [(e.range.start.line, e.range.end.line, e.new_text) for e in edits] == [(1, 2, "let b = 2\n")]


@pytest.mark.asyncio
async def test_symbols_of_the_workspace(client: LanguageClient):
    found = await client.workspace_symbol_async(T.WorkspaceSymbolParams("TILE"))
    assert [(s.name, s.location.uri.rsplit("/", 1)[1], covered(PARTS, s.location.range)) for s in found] == [("Tile", "parts.sc", "Tile")]
    found = await client.workspace_symbol_async(T.WorkspaceSymbolParams("righ"))
    assert [(s.name, s.container_name) for s in found] == [("right", "Tile")]
    assert {s.name for s in await client.workspace_symbol_async(T.WorkspaceSymbolParams(""))} >= {"n", "far", "Ready", "p", "meets", "Tile"}


@pytest.mark.asyncio
async def test_checks(client: LanguageClient):
    await clean(client)
    document = T.TextDocumentIdentifier(client.uri)
    lenses = await client.text_document_code_lens_async(T.CodeLensParams(document))
    assert [lens.command.title for lens in lenses] == ["check all 2", "check", "check"]
    answer = await client.workspace_execute_command_async(T.ExecuteCommandParams("scc.check", lenses[0].command.arguments))
    assert [(v["name"], v["verdict"]) for v in answer["verdicts"]] == [("meets", "holds"), ("apart", "violated")]
    found = await diagnostics(client, client.uri, lambda found: len(found) > 0)
    assert [(d.source, d.code, covered(MAIN, d.range)) for d in found] == [("scc check", "violated", "apart")]
    lenses = await client.text_document_code_lens_async(T.CodeLensParams(document))
    shows = [lens for lens in lenses if lens.command.title == "show the run"]
    answer = await client.workspace_execute_command_async(T.ExecuteCommandParams("scc.showRun", shows[0].command.arguments))
    assert "<html" in pathlib.Path(answer["page"].removeprefix("file://")).read_text()[:500]
    shown = await client.text_document_hover_async(T.HoverParams(**at(client, "apart")))
    assert "violated" in shown.contents.value
    # A change makes them verdicts of another text.
    change = T.TextDocumentContentChangePartial(T.Range(T.Position(99, 0), T.Position(99, 0)), "// more\n")
    client.text_document_did_change(T.DidChangeTextDocumentParams(T.VersionedTextDocumentIdentifier(2, client.uri), [change]))
    await diagnostics(client, client.uri, lambda found: found == ())


@pytest.mark.asyncio
async def test_models(client: LanguageClient):
    """Models of specs/ have no errors, and an answer to everything."""
    for path in sorted(MODELS.glob("*.sc"))[::9]:
        uri, text = path.as_uri(), path.read_text()
        opened(client, uri, text)
        found = await diagnostics(client, uri, lambda found: True)
        assert [d for d in found if d.severity == T.DiagnosticSeverity.Error] == [], path
        symbols = await client.text_document_document_symbol_async(T.DocumentSymbolParams(T.TextDocumentIdentifier(uri)))
        assert symbols, path
