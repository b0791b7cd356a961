"""A resources server for NeMo Gym that verifies answers to physics problems."""

from nemo_gym.base_resources_server import (
    BaseResourcesServerConfig,
    BaseVerifyRequest,
    BaseVerifyResponse,
    SimpleResourcesServer,
)

from sim2reason.rewards import score


class ProblemRequest(BaseVerifyRequest):
    """A response, and what it is graded by."""

    ground_truth: str


class ProblemResponse(BaseVerifyResponse):
    """The reward, with the outcome and the sentence that explain it."""

    outcome: str
    why: str


class Sim2ReasonResourcesServer(SimpleResourcesServer):
    """Right or wrong by the boxed answer."""

    config: BaseResourcesServerConfig

    async def verify(self, body: ProblemRequest) -> ProblemResponse:
        """Grade the text of a response."""
        grade = score(body.ground_truth, body.response.output_text)
        return ProblemResponse(**body.model_dump(), reward=grade.reward, outcome=grade.outcome, why=grade.why)


if __name__ == "__main__":
    Sim2ReasonResourcesServer.run_webserver()
